// Gradients in several directions: short vectors, negative sides.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { gradient <1, 0, 2> scale 3 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } }
sphere { 0, 1 pigment { gradient x color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { gradient <1, 2, -3> scale .4 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { gradient -y scale .7 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { gradient z turbulence .5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { gradient y frequency 0 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { gradient <.01, .02, 0> rotate x*30 scale .3 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, 1.2> }
