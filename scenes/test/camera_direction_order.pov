// The length of `direction` is the focal length, wherever it stands; `look_at` decides where it points.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 3, -9> look_at <0, 0, 0> right <1.4, 0, 0> direction <0, 0, 2> }
light_source { <4, 8, -8> rgb 1 }
box { -1, 1 pigment { rgb <0.8, 0.7, 0.4> } }
sphere { <0, 1.5, 0>, 0.5 pigment { rgb <0.6, 0.4, 0.8> } }
