// Hexagons and the sixths of them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
plane { y, -1 pigment { hexagon rgb <.9, .8, .6>, rgb <.5, .3, .2>, rgb .2 scale .4 } }
sphere { <-1.2, 0, 0>, 1 pigment { triangular scale .5 rotate x*90 } }
box { <.4, -.8, -.8>, <2, .8, .8> pigment { triangular rgb 1, rgb .8, rgb .6, rgb .4, rgb .2, rgb 0 scale .6 rotate x*60 } rotate y*20 }
