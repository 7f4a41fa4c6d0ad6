// A `right` that points to -x makes the picture its mirror image, as right-handed scenes ask for.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2, -5> right <-1.33, 0, 0> look_at <0, 0, 0> }
light_source { <4, 8, -8> rgb 1 }
box { <-1.2, -0.6, -0.6>, <0.2, 0.6, 0.6> pigment { rgb <0.9, 0.8, 0.4> } }
sphere { <1, 0, 0>, 0.6 pigment { rgb <0.5, 0.5, 0.9> } }
