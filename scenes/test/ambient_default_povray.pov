// In POV-Ray's dialect the ambient light is white when nothing is said: the unlit side is not black.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 0, 0> }
light_source { <6, 3, -1> rgb <0.9, 0.9, 0.8> }
sphere { <0, 0, 0>, 1.2 pigment { rgb <0.9, 0.8, 0.6> } }
