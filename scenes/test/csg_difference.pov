#version 3.7;
// A die without its pips, a ring, and what a cutter without a texture leaves: the default's black.
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -5> look_at <0, 0.2, 0> angle 40 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
difference {
  box { <-1, -1, -1>, <1, 1, 1> pigment { color rgb <0.9, 0.2, 0.1> } finish { phong 0.6 phong_size 40 } }
  sphere { <0, 0, -1.1>, 0.5 pigment { color rgb <0.9, 0.9, 0.2> } }
  sphere { <0.9, 0.7, 0.1>, 0.6 pigment { color rgb <0.1, 0.8, 0.3> } }
  cylinder { <-0.4, 0, 0>, <-0.4, 2, 0>, 0.35 pigment { color rgb <0.2, 0.4, 1> } }
  rotate <0, 25, 0>
}
difference {
  cylinder { <0, 0, 0>, <0, 0.5, 0>, 0.8 }
  cylinder { <0, -0.1, 0>, <0, 0.6, 0>, 0.5 }
  pigment { color rgb <0.8, 0.7, 0.5> }
  rotate <-60, 30, 0>
  translate <1.9, -0.6, -0.6>
}
difference {
  sphere { <-1.9, -0.3, -0.4>, 0.7 pigment { color rgb <1, 0.6, 0.8> } }
  box { <-3, -0.3, -2>, <-1.7, 1, 0> }
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
