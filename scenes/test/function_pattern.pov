// Formulas as patterns of pigments, also through other functions, patterns and pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#declare Wave = function (x, y) { sin(x * 6) * cos(y * 6) * .5 + .5 }
#declare Noise = function { pattern { bozo turbulence .3 scale .3 } }
#declare Stripes = function { pigment { gradient y color_map { [.5 rgb 0] [.5 rgb <1, .5, 0>] } scale .3 } }
plane { y, -1 pigment { function { Wave(x, z) } color_map { [0 rgb <.1, .2, .5>] [.5 rgb 1] [1 rgb <.8, .3, .1>] } } }
sphere { <-1.5, .2, 0>, 1.1 pigment { function { abs(x * y) + z*z } color_map { [0 rgb x] [.5 rgb 1] [1 rgb z] } frequency 2 turbulence .2 scale .8 } }
sphere { <1.5, .2, 0>, 1.1 pigment { function { Noise(x, y, z) * Stripes(x, y, z).red } pigment_map { [0 rgb <.1, .4, .2>] [1 checker scale .1] } rotate z*20 } }
