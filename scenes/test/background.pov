// The background is seen where nothing is, in mirrors and through glass; the last one counts.
#version 3.7;
global_settings { assumed_gamma 1 }
background { color rgb <1, 0, 0> }
background { color rgb <0.2, 0.4, 0.6> }
camera { location <0, 0.5, -5> look_at <0, 0, 0> }
light_source { <3, 5, -6> rgb 1 }
sphere { <-1.1, 0, 0>, 1 pigment { rgb 0.1 } finish { reflection 0.8 } }
sphere { <1.1, 0, 0>, 1 pigment { rgbf <1, 0.8, 0.6, 0.9> } interior { ior 1.3 } }
