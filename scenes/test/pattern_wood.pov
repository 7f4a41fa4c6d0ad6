// Wood: rings that turbulence bends, and how they stand.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { wood turbulence .08 scale .4 rotate x*80 } }
sphere { 0, 1 pigment { wood scale .3 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { wood turbulence .1 scale .3 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { wood turbulence <.1, .2, .3> octaves 3 lambda 3 sine_wave frequency 2.5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { wood turbulence .04 rotate <80, 20, 0> scale .25 } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { wood turbulence <.3, 0, 0> scale .3 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { wood turbulence <0, 0, 1> scale .3 } translate <2.3, .1, 1.2> }
