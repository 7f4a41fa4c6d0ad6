// From 3.7 on it keeps 1 - filter - transmit, and assumed_gamma is 1 when it is not given.
#version 3.7;
global_settings { ambient_light rgb 0.5 }
camera { location <0, 0.5, -4> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
sphere { <0, 0, 0>, 1.2 pigment { rgbft <0.5, 0.3, 0.2, 0.6, 0.1> } }
