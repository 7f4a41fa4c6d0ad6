#version 3.7;
// Patterns of members and of wholes: they move with what they were written in, and colour the light.
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <1, 3, -6> look_at <0, 0, 0> angle 42 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
difference {
  box { <-1, -1, -1>, <1, 1, 1> pigment { checker color rgb <0.9, 0.3, 0.2> color rgb <1, 1, 0.8> scale 0.3 } rotate <0, 20, 0> }
  sphere { <0, 0.4, -1>, 0.9 translate <0, 0.2, 0> }
  pigment { checker color rgb <0.2, 0.5, 0.9> color rgb <0.9, 0.9, 0.9> scale 0.2 rotate <0, 0, 30> }
  rotate <0, 15, 0>
  translate <-1, 0, 0>
}
difference {
  sphere { <0, 0, 0>, 1 }
  sphere { <0, 0.6, 0>, 0.8 }
  pigment { checker color rgbf <1, 0.3, 0.3, 0.9> color rgbf <0.3, 1, 0.3, 0.7> scale 0.4 }
  rotate <20, 0, 20>
  translate <1.6, 0, 0>
}
union {
  sphere { <-2.5, -0.6, -1.5>, 0.4 }
  sphere { <0, 0, 0>, 0.3 translate <-1.7, -0.6, -1.8> }
  pigment { checker color rgb <0.2, 0.2, 0.2> color rgb <0.9, 0.9, 0.5> scale 0.15 }
  rotate <0, 10, 0>
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.8 } }
