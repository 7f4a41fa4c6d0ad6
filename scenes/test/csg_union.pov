#version 3.7;
// Textures and transformations of unions in unions hold for what has none of its own.
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at <0, 0.3, 0> angle 40 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
union {
  sphere { <0, 0, 0>, 0.5 }
  union {
    box { <-0.3, -0.3, -0.3>, <0.3, 0.3, 0.3> rotate <0, 30, 0> }
    cone { <0, 0.3, 0>, 0.3, <0, 1, 0>, 0 pigment { color rgb <0.2, 0.9, 0.3> } }
    pigment { color rgb <0.2, 0.4, 1> }
    scale <1, 1.5, 1>
    translate <1.2, 0.2, 0>
  }
  cylinder { <-2, -0.5, 0>, <-1, 0.5, 0>, 0.3 no_shadow }
  pigment { color rgb <0.9, 0.2, 0.1> }
  finish { phong 0.5 }
  rotate <0, -20, 0>
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
