// Walls through the middle of the coordinates lie on the sides of tiles: they show those behind them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.9, .8, .6> } }
box { <-3, -1, 0>, <-1.2, 1, 1> pigment { tiling 5 scale .4 } }
box { <-.9, -1, 0>, <.9, 1, 1> pigment { triangular scale .3 } }
box { <1.2, -1, 0>, <3, 1, 1> pigment { tiling 9 scale .3 } }
