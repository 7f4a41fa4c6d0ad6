#version 3.7;
// One interior for a union: each of its surfaces leads in or out, inner ones too, as POV-Ray has it; merge is meant.
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2.5, -7> look_at <0, 0, 0> angle 40 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
union {
  sphere { <-0.4, 0, 0>, 0.9 }
  box { <-0.2, -0.7, -0.7>, <1.2, 0.7, 0.7> }
  pigment { color rgbf <0.8, 0.9, 1, 0.9> }
  interior { ior 1.5 }
  rotate <0, 25, 0>
  translate <-1.4, 0, 0>
}
union {
  sphere { <-0.4, 0, 0>, 0.8 interior { ior 1.5 } }
  sphere { <0.4, 0, 0>, 0.8 interior { ior 1.2 } }
  pigment { color rgbf <1, 0.9, 0.8, 0.9> }
  translate <1.4, 0, 0>
}
box { <-3, -0.8, 1.5>, <3, -0.4, 2> pigment { color rgb <1, 0.3, 0.2> } }
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
