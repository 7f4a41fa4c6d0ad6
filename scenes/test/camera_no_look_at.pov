// Without `look_at` the camera's vectors are taken as they are written, here leaning a little.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -4> direction <0.2, -0.1, 1> right <1.3, 0.2, 0> up <-0.15, 1, 0> }
light_source { <4, 8, -8> rgb 1 }
box { <-0.8, -0.8, -0.5>, <0.8, 0.8, 0.5> pigment { rgb <0.5, 0.8, 0.6> } }
sphere { <1.4, 0.9, 0>, 0.5 pigment { rgb <0.9, 0.6, 0.4> } }
