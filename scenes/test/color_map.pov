// Maps of colours: intervals, steps, entries that do not rise, values beyond both ends, names.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#declare Stripes = color_map { [.1 rgb x] [.1 rgb 1] [.4, .6 color rgb <0, .6, .2> color rgb <.1, .2, .8>] [.6 rgb x + y] [.9 rgb .1] }
plane { y, -1 pigment { gradient x color_map { Stripes } scale 2 translate .3 } }
sphere { <-2, 0, 0>, .9 pigment { spherical colour_map { [0 rgb 1] [.3 rgb x] [.3 rgb y] [1 rgb z] } scale 2 translate <-2, .9, -1> } }
sphere { <0, 0, 0>, .9 pigment { gradient y color_map { [.6 rgb x] [.2 rgb z] } } }
sphere { <2, 0, 0>, .9 pigment { radial color_map { Stripes } frequency 6 rotate x*60 } finish { phong .5 } }
sphere { <0, 1.6, 1>, .6 pigment { onion color_map { [.5 rgbt <1, .5, 0, .2>] [.5 rgbf <.2, .4, 1, .8>] } scale .3 } }
