// Bricks: the list, sizes and mortar, and a brick turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
box { -1, 1 pigment { brick scale .2 } rotate y*30 translate x*-2.3 }
sphere { 0, 1.2 pigment { brick rgb .9, rgb <.2, .3, .6> brick_size <.7, .3, .5> mortar .06 } }
box { -1, 1 pigment { brick rgb 1, rgb <.1, .5, .2> mortar 1 scale <.1, .15, .1> rotate <20, 10, 40> } rotate y*-30 translate x*2.3 }
plane { y, -1.3 pigment { rgb .6 } }
