#version 3.7;
// Solids with holes and solids without end as members: tori, half spaces, a cone of two nappes.
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <1, 3, -6> look_at <0, 0, 0> angle 42 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
difference {
  torus { 1, 0.4 rotate <20, 0, 0> }
  torus { 1, 0.25 rotate <20, 0, 0> }
  box { <-2, -1, -2>, <0.2, 1, 0> }
  pigment { color rgb <0.9, 0.5, 0.2> }
}
difference {
  box { <1.6, -1, -0.5>, <2.8, 0.5, 0.5> pigment { color rgbf <0.6, 0.9, 1, 0.9> } }
  torus { 0.4, 0.2 rotate <90, 0, 0> translate <2.2, 0, -0.5> pigment { color rgbf <1, 0.8, 0.6, 0.9> } }
  interior { ior 1.3 }
}
intersection {
  quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -0.1 }
  quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, -0.6 }
  quadric { <0, 0, 0>, <0, 0, 0>, <0, -1, 0>, -0.7 }
  torus { 0.7, 0.3 translate <0, 0.3, 0> inverse }
  pigment { color rgb <0.6, 0.9, 0.3> }
  translate <-2.2, 0, 0>
}
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 1 clipped_by { sphere { <0, -1, 0>, 5 } } pigment { color rgb 0.8 } }
