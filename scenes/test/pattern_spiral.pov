// Spirals of several arms, both ways, with turbulence and without.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { spiral1 5 rotate x*90 color_map { [.5 rgb .9] [.5 rgb <.3, .4, .6>] } } }
sphere { 0, 1 pigment { spiral1 3 scale .4 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { spiral1 5 turbulence .2 scale .5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { spiral1 -2 ramp_wave scale .5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { spiral2 3 scale .5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { spiral2 2 turbulence <.3, .1, .2> scale .5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { spiral2 2.9 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, 1.2> }
