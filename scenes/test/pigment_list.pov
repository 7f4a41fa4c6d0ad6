// Lists whose members are pigments: the pattern moves them, and they have transformations of their own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#declare Fine = pigment { gradient x color_map { [.5 rgb .9] [.5 rgb <.2, .3, .7>] } scale .1 }
plane { y, -1 pigment { hexagon pigment { Fine } pigment { Fine rotate y*60 color_map { [0 rgb 1] [1 rgb x] } } pigment { rgb <.9, .8, .3> } } }
sphere { <-1.5, .2, 0>, 1.1 pigment { checker pigment { Fine rotate z*30 } pigment { rgb <.8, .4, .2> } scale .5 rotate 15 } }
sphere { <1.5, .2, 0>, 1.1 pigment { brick pigment { rgb .3 } pigment { cells color_map { [0 rgb <.6, .1, .1>] [1 rgb <.9, .4, .3>] } } scale .15 } }
