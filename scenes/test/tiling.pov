// Tilings with and without a formula of their own, and pavement of one cell.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#macro Tile(X, Y, P) box { <-1, -1, 0>, <1, 1, .1> pigment { P scale .3 rotate x*-90 } finish { ambient 1 diffuse 0 } translate <X, Y, 0> } #end
#declare M = color_map { [0 rgb <0, .1, .3>] [.3 rgb <0, .7, .6>] [.6 rgb <1, .8, .2>] [.8 rgb <.8, .2, 0>] [1 rgb 1] }
Tile(-2.1, 1.05, pigment { tiling 6 color_map { M } })
Tile(0, 1.05, pigment { tiling 12 color_map { M } })
Tile(2.1, 1.05, pigment { tiling 17 color_map { M } })
Tile(-2.1, -1.05, pigment { tiling 21 color_map { M } })
Tile(0, -1.05, pigment { tiling 24 color_map { M } })
Tile(2.1, -1.05, pigment { pavement number_of_sides 6 color_map { M } })
