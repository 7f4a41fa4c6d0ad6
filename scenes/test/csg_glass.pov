#version 3.7;
// A glass bowl, a glass lens with a hole, and glass that was merged: rays are bent by each solid as a whole.
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2.5, -7> look_at <0, 0, 0> angle 40 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
difference {
  sphere { <0, 0, 0>, 1 }
  sphere { <0, 0.3, 0>, 0.85 }
  box { <-2, 0.4, -2>, <2, 2, 2> }
  pigment { color rgbf <0.8, 1, 0.9, 0.9> }
  finish { reflection 0.1 phong 0.8 }
  interior { ior 1.5 }
  translate <-1.7, 0, 0>
}
difference {
  intersection { sphere { <0, 0, -0.8>, 1.2 } sphere { <0, 0, 0.8>, 1.2 } }
  cylinder { <0, 0, -2>, <0, 0, 2>, 0.25 }
  pigment { color rgbf <1, 0.9, 0.7, 0.95> }
  interior { ior 1.4 }
  rotate <0, 20, 0>
  translate <0.4, 0.1, -0.5>
}
merge {
  sphere { <-0.3, 0, 0>, 0.6 }
  box { <-0.2, -0.5, -0.5>, <0.9, 0.5, 0.5> }
  pigment { color rgbf <0.8, 0.8, 1, 0.9> }
  interior { ior 1.3 }
  rotate <10, 30, 0>
  translate <2, 0, 0.3>
}
box { <-3, -0.8, 1.5>, <3, -0.4, 2> pigment { color rgb <1, 0.3, 0.2> } }
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
