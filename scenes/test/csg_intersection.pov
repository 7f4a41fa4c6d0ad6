#version 3.7;
// A lens, a cube with its corners rounded off, and three cylinders at right angles.
global_settings { assumed_gamma 1 }
camera { location <0.5, 3, -6> look_at <0, 0, 0> angle 40 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
intersection {
  box { <-1, -1, -1>, <1, 1, 1> pigment { color rgb <0.9, 0.6, 0.1> } }
  sphere { <0, 0, 0>, 1.35 pigment { color rgb <0.3, 0.3, 0.9> } finish { phong 0.8 } }
  rotate <20, 30, 0>
}
intersection {
  sphere { <0, 0, -0.8>, 1 }
  sphere { <0, 0, 0.8>, 1 }
  pigment { color rgb <0.2, 0.9, 0.4> }
  rotate <0, 50, 0>
  scale 1.4
  translate <2.2, 0, 0>
}
intersection {
  cylinder { <-1, 0, 0>, <1, 0, 0>, 0.5 pigment { color rgb <1, 0.3, 0.3> } }
  cylinder { <0, -1, 0>, <0, 1, 0>, 0.5 pigment { color rgb <0.3, 1, 0.3> } }
  cylinder { <0, 0, -1>, <0, 0, 1>, 0.5 pigment { color rgb <0.3, 0.3, 1> } }
  rotate <10, 40, 20>
  translate <-2.1, 0.1, 0>
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
