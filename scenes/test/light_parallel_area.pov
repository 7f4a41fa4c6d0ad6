// Parallel light from the points of an area: each goes where the middle points at. And a beam of a cylinder.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
background { rgb <.3, .5, .8> }
light_source { <6, 7, -6> rgb .7 parallel point_at 0 area_light 3*x, 3*y, 4, 3 }
light_source { <-6, 9, -4> rgb <.5, .3, .2> cylinder radius 2 falloff 4 point_at <0, 0, 1> area_light <2, 0, 2>, y, 3, 2 area_illumination }
plane { y, -1 pigment { rgb <.9, .8, .6> } }
sphere { <-1.5, .6, -1>, .7 pigment { rgb <.9, .3, .2> } }
box { <.6, -1, -1>, <1.6, 1.4, 0> pigment { rgb <.2, .5, .8> } rotate 20*y }
