// Slopes and heights beyond their bounds begin again before their waves are made.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#declare M = color_map { [0 rgb <.1, .2, .6>] [.3 rgb <.2, .6, .2>] [.6 rgb <.9, .8, .5>] [1 rgb 1] }
sphere { <-2, 0, 0>, 1.1 pigment { slope { y, .3, .7 } frequency .5 color_map { M } } }
sphere { <.1, 0, 0>, 1 pigment { slope { y, 0, .5 altitude y, -.5, .5 } triangle_wave frequency 2.5 color_map { M } } }
sphere { <2.2, 0, 0>, 1.1 pigment { slope { <1, 1, 0> altitude y, -.3, .2 } frequency -.7 phase .2 color_map { M } } }
