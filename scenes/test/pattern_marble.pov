// Marble: turbulence adds to its value instead of moving points.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { marble turbulence .7 scale 1.5 } }
sphere { 0, 1 pigment { marble scale .4 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { marble turbulence .8 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { marble turbulence <.4, 2, 2> ramp_wave octaves 3 omega .7 scale .7 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { marble turbulence 1 noise_generator 1 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { marble turbulence .5 rotate z*50 scale .5 } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { marble turbulence .8 sine_wave frequency 2 } translate <2.3, .1, 1.2> }
