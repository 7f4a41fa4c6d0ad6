// The brightness of a pigment as the value of a pattern.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
plane { y, -1 pigment { pigment_pattern { cells color_map { [0 rgb x] [1 rgb y] } scale .5 } color_map { [.25 rgb z] [.3 rgb x] [.5 rgb 1] } rotate y*30 } }
sphere { <-1.2, .2, 0>, 1.1 pigment { pigment_pattern { checker rgb .2, rgb <0, 1, 0> scale .3 } pigment_map { [.2 rgb 1] [.58 gradient x scale .1] } rotate 20 } }
sphere { <1.2, .2, 0>, 1.1 pigment { pigment_pattern { marble color_map { [0 rgb 0] [1 rgb 1] } turbulence .6 } color_map { [0 rgb .2] [1 rgb <1, .8, .4>] } frequency 3 scale .4 } }
