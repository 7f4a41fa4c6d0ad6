// Maps of pigments that are patterns themselves, and averages of them by weight.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#declare Tiles = pigment { checker rgb 1, rgb <.9, .2, .1> scale .3 }
#declare Blend = pigment_map { [0 Tiles] [.3 Tiles scale .5 rotate y*45] [.6 color rgb <.1, .2, .9>] [1 cells color_map { [0 rgb 1] [1 rgb <.8, .8, 0>] } scale .2] }
plane { y, -1 pigment { crackle pigment_map { Blend } scale 1.5 rotate y*30 } }
sphere { <-1.5, .2, 0>, 1.1 pigment { gradient y pigment_map { Blend } scale 2 translate -y } }
sphere { <1.5, .2, 0>, 1.1 pigment { average pigment_map { [1 Tiles] [2 square pigment { rgb x } pigment { Tiles } pigment { rgb 0 } pigment { rgb z } scale .5] } rotate 20 } }
