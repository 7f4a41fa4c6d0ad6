// Colours by the direction of the surface, and by the angle to the ray.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#declare M = color_map { [0 rgb <.1, .2, .6>] [.45 rgb <.2, .6, .2>] [.55 rgb <.9, .8, .5>] [1 rgb 1] }
sphere { <-2, 0, 0>, 1.1 pigment { slope y color_map { M } } }
torus { .8, .35 rotate x*-50 pigment { slope { <1, 1, -.5>, .2, .9 } color_map { M } } translate x*.2 }
sphere { <2.2, 0, 0>, 1.1 pigment { aoi color_map { M } } }
sphere { <0, -1.7, 1>, .7 pigment { slope { y, 0, 1 altitude y, -3, 0 } color_map { M } } }
