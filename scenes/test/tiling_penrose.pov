// Penrose's tilings: pentagons, kites and darts, rhombi.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#declare M = color_map { [0 rgb <0, .1, .3>] [.3 rgb <0, .7, .6>] [.6 rgb <1, .8, .2>] [.8 rgb <.8, .2, 0>] [1 rgb 1] }
#macro Tile(X, N) box { <-1, -1, 0>, <1, 2, .1> pigment { tiling N color_map { M } scale .3 rotate x*-90 } translate X*x } #end
Tile(-2.1, 25)
Tile(0, 26)
Tile(2.1, 27)
