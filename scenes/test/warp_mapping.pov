// Patterns laid round: spherical, cylindrical, toroidal, planar and cubic.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { checker rgb .9, rgb <.3, .4, .6> scale .2 warp { planar y, .1 } } }
sphere { 0, 1 pigment { checker rgb 1, rgb x scale .1 warp { spherical } } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { gradient x scale .1 warp { cylindrical } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { checker rgb 1, rgb y scale .1 warp { toroidal major_radius .5 orientation x } } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { checker rgb 1, rgb z scale .1 warp { cubic } } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { gradient y scale .2 warp { spherical orientation y dist_exp 1 } rotate x*40 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { checker rgb 1, rgb <1, 0, 1> scale .2 warp { cylindrical dist_exp .5 orientation <1, 1, 0> } } translate <2.3, .1, 1.2> }
