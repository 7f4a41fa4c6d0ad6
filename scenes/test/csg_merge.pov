#version 3.7;
// Clear solids that were merged show no faces within; those that were united do.
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2, -7> look_at <0, 0, 0> angle 40 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
merge {
  sphere { <-0.5, 0, 0>, 0.8 }
  sphere { <0.4, 0.2, 0>, 0.8 }
  box { <-0.4, -0.9, -0.4>, <0.4, 0, 0.4> }
  pigment { color rgbf <1, 0.8, 0.6, 0.8> }
  finish { phong 0.5 }
  translate <-1.6, 0, 0>
}
union {
  sphere { <-0.5, 0, 0>, 0.8 }
  sphere { <0.4, 0.2, 0>, 0.8 }
  box { <-0.4, -0.9, -0.4>, <0.4, 0, 0.4> }
  pigment { color rgbf <0.6, 0.8, 1, 0.8> }
  finish { phong 0.5 }
  translate <1.6, 0, 0>
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
