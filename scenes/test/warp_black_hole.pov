// Black holes: attracting, pushing, and repeated.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { checker rgb .9, rgb <.3, .4, .6> warp { black_hole <1.5, -1, -2>, 2 falloff 1 strength 1.5 } warp { black_hole <-2, -1, 1>, 2.5 inverse } } }
sphere { 0, 1 pigment { gradient x scale .3 warp { black_hole <.2, .2, -.9>, .9 strength 2 falloff 3 } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { gradient y scale .3 warp { black_hole <.3, .3, .3>, .3 repeat <.7, .7, .7> } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { gradient <1, 1, 0> scale .3 warp { black_hole <0, .2, -1>, .8 inverse falloff 1.5 } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
