// Bumps on uv coordinates push along the axes of the scene, however the object is turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.9, .8, .6> } }
sphere { 0, 1 pigment { rgb <.9, .5, .3> } normal { uv_mapping bumps .6 scale .05 } rotate <20, 50, -30> translate <-2.3, .1, -1> }
box { -.8, .8 uv_mapping texture { pigment { rgb <.4, .7, .4> } normal { gradient x, .5 triangle_wave scale .04 } } rotate <-30, 40, 10> translate <0, .2, -1> }
torus { .7, .35 pigment { rgb <.4, .5, .9> } normal { uv_mapping checker normal { bumps .5 scale .05 } normal { wrinkles .7 scale .1 } scale .2 } rotate <-60, 0, 30> translate <2.3, .2, -1> }
