// A view of 120 degrees stretches what is near its edges.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at <0, 0, 0> angle 120 }
light_source { <4, 8, -8> rgb 1 }
sphere { <-2.5, 1.2, 0>, 0.8 pigment { rgb <0.9, 0.4, 0.4> } }
sphere { <0, 0, 0>, 0.8 pigment { rgb <0.4, 0.9, 0.4> } }
sphere { <3, -1.4, 0>, 0.8 pigment { rgb <0.4, 0.4, 0.9> } }
