// Turbulence as a warp stands where it is written.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { checker rgb .9, rgb <.3, .4, .6> scale 1.5 warp { turbulence .5 octaves 3 } } }
sphere { 0, 1 pigment { gradient x warp { turbulence .3 } scale .4 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { gradient x scale .4 warp { turbulence .3 } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { gradient y scale .5 warp { turbulence <.5, .2, .1> lambda 2.5 omega .4 } rotate z*30 warp { turbulence .1 octaves 2 } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
