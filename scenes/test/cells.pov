// A random number for each cube, as colours of a map.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
sphere { <-1.3, 0, 0>, 1.2 pigment { cells scale .3 color_map { [0 rgb <.1, .2, .5>] [.5 rgb <.9, .8, .2>] [1 rgb <.8, .1, .1>] } } }
box { <.2, -1, -.8>, <2.2, 1, .8> pigment { cells scale <.3, .1, .2> turbulence .4 } rotate y*25 }
