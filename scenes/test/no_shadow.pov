// An object with no_shadow stands in no light's way but is seen as ever, also in mirrors.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0, 0> }
light_source { <3, 8, -3> rgb 1 }
sphere { <-1.2, 0, 0>, 0.8 no_shadow pigment { rgb <0.9, 0.6, 0.4> } }
sphere { <1.2, 0, 0>, 0.8 pigment { rgb <0.4, 0.6, 0.9> } }
box { <-5, -1.2, -3>, <5, -1, 5> pigment { rgb 0.6 } finish { reflection 0.3 } }
