// Crackle: usual, other forms, metrics and an offset, solid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#macro Ball(X, Y, P) sphere { <X, Y, 0>, .9 pigment { P } } #end
#declare M = color_map { [0 rgb <.1, .05, 0>] [.15 rgb <.6, .3, .1>] [1 rgb <1, .95, .8>] }
Ball(-2, 1, pigment { crackle scale .4 color_map { M } })
Ball(0, 1, pigment { crackle form <1, 0, 0> scale .4 color_map { M } })
Ball(2, 1, pigment { crackle form <-1, .3, .6> metric 3 scale .4 color_map { M } })
Ball(-2, -1, pigment { crackle metric 1 offset .2 scale .4 color_map { M } })
Ball(0, -1, pigment { crackle solid scale .3 })
Ball(2, -1, pigment { crackle turbulence .3 scale .4 color_map { M } })
