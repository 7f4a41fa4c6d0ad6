// Without a camera in POV-Ray's dialect: the same view, but right is 1.33 and not 1.33333.
#version 3.7;
global_settings { assumed_gamma 1.0 }
light_source { <-5, 8, -3> rgb 1 }
sphere { <0, 0, 6>, 1 pigment { rgb <0.9, 0.5, 0.3> } }
box { <1.4, -1, 5>, <2.4, 1.6, 7> pigment { rgb <0.4, 0.7, 0.9> } }
