#version 3.7;
// Surfaces that were cut open, by what was moved with them and by what was not; flat ones too.
global_settings { assumed_gamma 1 }
camera { location <1, 2.5, -6> look_at <0, 0, 0> angle 42 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
sphere {
  <0, 0, 0>, 1
  clipped_by { box { <-2, -2, -2>, <2, 0.4, 2> } }
  pigment { color rgb <0.9, 0.3, 0.2> }
  finish { phong 0.5 }
}
sphere {
  <0, 0, 0>, 0.8
  rotate <0, 0, 45>
  clipped_by { box { <0, -2, -2>, <2, 2, 2> } }
  rotate <0, 30, 0>
  translate <-2, 0, 0>
  pigment { color rgb <0.3, 0.6, 0.9> }
}
difference {
  box { <-0.7, -0.7, -0.7>, <0.7, 0.7, 0.7> pigment { color rgb <0.8, 0.8, 0.3> } }
  sphere { <0, 0, 0>, 0.85 pigment { color rgb <0.3, 0.8, 0.4> } }
  clipped_by { sphere { <0.3, 0, -0.3>, 1 inverse } }
  rotate <10, 30, 0>
  translate <2, 0, 0>
}
union {
  cylinder { <-3, -0.9, -1.5>, <3, -0.9, -1.5>, 0.1 }
  box { <-3, -1, -2>, <3, -0.95, -1> }
  clipped_by { cylinder { <0, -2, -1.5>, <0, 2, -1.5>, 0.6 } box { <-0.5, -2, -3>, <3, 2, 3> } }
  pigment { color rgb <0.9, 0.5, 0.9> }
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> clipped_by { sphere { <0, -1, 0>, 4 } } pigment { color rgb 0.7 } }
intersection {
  polygon { 4, <-3, -1, 2>, <3, -1, 2>, <3, 2, 2>, <-3, 2, 2> }
  sphere { <0, 0.5, 2>, 1.5 }
  pigment { color rgb <0.4, 0.9, 0.9> }
}
merge {
  polygon { 4, <-3.5, -1, 0>, <-1.5, -1, 0.5>, <-1.5, 1.3, 0.5>, <-3.5, 1.3, 0> }
  sphere { <-2.9, 0.8, 0.2>, 0.5 }
  pigment { color rgb <0.9, 0.9, 0.4> }
}
