// Pavements whose tiles have several cells, with cut and rounded corners.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#declare M = color_map { [0 rgb <.9, .7, .5>] [.6 rgb <.6, .4, .3>] [.9 rgb <.2, .1, .1>] [1 rgb .1] }
#macro Paved(X, Y, P) box { <-1, -1, 0>, <1, 1, .1> pigment { P color_map { M } scale .3 rotate x*-90 } finish { ambient .5 } translate <X, Y, 0> } #end
Paved(-2.1, 1.05, pigment { pavement number_of_sides 3 number_of_tiles 4 pattern 2 exterior 2 form 1 })
Paved(0, 1.05, pigment { pavement number_of_sides 3 number_of_tiles 6 pattern 7 interior 1 })
Paved(2.1, 1.05, pigment { pavement number_of_sides 4 number_of_tiles 5 pattern 8 exterior 1 interior 2 form 3 })
Paved(-2.1, -1.05, pigment { pavement number_of_sides 4 number_of_tiles 4 pattern 5 exterior 2 form 2 })
Paved(0, -1.05, pigment { pavement number_of_sides 6 number_of_tiles 4 pattern 6 interior 2 form 2 })
Paved(2.1, -1.05, pigment { pavement number_of_sides 6 number_of_tiles 5 pattern 14 form 1 interior 1 })
