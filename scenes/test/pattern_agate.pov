// Agate with its own turbulence and with that of all patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { agate scale 2 } }
sphere { 0, 1 pigment { agate scale .5 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { agate agate_turb .3 scale .6 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { agate turbulence .4 scale .6 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { agate turbulence .2 octaves 3 omega .6 lambda 2.3 agate_turb 1.4 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { agate noise_generator 1 scale .4 } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { agate noise_generator 3 scale .4 } translate <2.3, .1, 1.2> }
