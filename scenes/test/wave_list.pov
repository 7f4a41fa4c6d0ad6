// Wave forms of lists, whose numbers they shape: members mix.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
box { <-3, 2.2, 0>, <3, 2.55, 1> pigment { square rgb x, rgb y, rgb z, rgb 1 rotate x*90 scale .2 sine_wave } }
box { <-3, 1.8, 0>, <3, 2.15, 1> pigment { square rgb x, rgb y, rgb z, rgb 1 rotate x*90 scale .2 frequency .5 } }
box { <-3, 1.4, 0>, <3, 1.75, 1> pigment { checker rgb x, rgb y scale .2 frequency .3 phase .4 triangle_wave } }
box { <-3, 1.0, 0>, <3, 1.35, 1> pigment { checker rgb x, rgb y scale .2 phase .4 } }
box { <-3, .6, 0>, <3, .95, 1> pigment { hexagon pigment { rgb x } pigment { gradient x scale .1 } pigment { rgb z } rotate x*90 scale .15 frequency .7 } }
box { <-3, .2, 0>, <3, .55, 1> pigment { hexagon rgb x, rgb y, rgb z rotate x*90 scale .15 poly_wave 2 } }
box { <-3, -.2, 0>, <3, .15, 1> pigment { hexagon rgb x, rgb y, rgb z rotate x*90 scale .15 cubic_wave } }
plane { y, -.5 pigment { brick rgb .2, rgb 1 scale .1 frequency .6 scallop_wave } }
