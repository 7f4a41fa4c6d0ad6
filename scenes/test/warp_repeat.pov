// A pattern that repeats: steps aside, odd cells that are turned round, and both.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { spherical color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } translate <.5, 0, .5> scale <1, 2, 1> warp { repeat x } warp { repeat z offset x*.5 } } }
sphere { 0, 1 pigment { spherical scale .3 translate <.3, .2, .3> warp { repeat x*.6 } warp { repeat y*.5 flip y } warp { repeat .6*z } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { gradient y scale .3 rotate z*30 warp { repeat x*.5 flip x } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { onion scale .4 warp { repeat .7*y flip <1, 0, 1> offset <.2, 0, .1> } color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
