// Cushions by three pairs of controls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { quilted color_map { [0 rgb .1] [1 rgb <.9, .8, .6>] } } }
sphere { 0, 1 pigment { quilted scale .5 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { quilted control0 .3 control1 .7 scale .5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { quilted control0 1 control1 0 scale .6 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
