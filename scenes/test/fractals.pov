// mandel, julia and magnet, inside and outside in several ways.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#macro Tile(X, Y, P) box { <-1, -1, 0>, <1, 1, .1> pigment { P } finish { ambient 1 diffuse 0 } translate <X, Y, 0> } #end
#declare M = color_map { [0 rgb 0] [.1 rgb <.2, 0, .5>] [.3 rgb <1, .5, 0>] [.6 rgb <1, 1, .5>] [1 rgb <0, .3, .3>] }
Tile(-2.1, 1.05, pigment { mandel 30 color_map { M } translate x*.5 scale .7 })
Tile(0, 1.05, pigment { mandel 20 exponent 4 interior 1, 1.5 exterior 6, .3 color_map { M } scale .8 })
Tile(2.1, 1.05, pigment { julia <.36, .1>, 40 color_map { M } scale .7 })
Tile(-2.1, -1.05, pigment { magnet 1 mandel 30 color_map { M } translate x*-1 scale .5 })
Tile(0, -1.05, pigment { magnet 2 julia <.3, .4>, 25 exterior 1, 1 color_map { M } scale .5 })
Tile(2.1, -1.05, pigment { mandel 12 })
