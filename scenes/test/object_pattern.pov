// Objects as patterns: one pigment inside of them, one outside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#declare Shapes = union { sphere { 0, .4 } difference { box { -1.2, -.2 } sphere { <-.6, -.2, -.6>, .35 } } cylinder { 0, 2*x, .15 } intersection { sphere { y, .5 } box { -1, 1 inverse rotate z*30 } } }
plane { y, -1 pigment { object { torus { .7, .2 } color rgb <.9, .9, .5> color rgb <.1, .3, .6> } translate <1, -1.25, 1> warp { repeat x*2 } warp { repeat z*2 } scale .8 } }
sphere { <-1.5, .2, 0>, 1.1 pigment { object { Shapes rgb <.9, .5, .1>, rgb y + z } scale .8 rotate 30 translate <-1.5, .3, -.9> } }
sphere { <1.5, .2, 0>, 1.1 pigment { object { sphere { .35, .3 inverse } pigment { checker scale .1 } pigment { rgb 1 } } warp { repeat x*.7 } warp { repeat y*.7 } warp { repeat z*.7 } } }
