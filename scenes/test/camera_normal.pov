// The rays of a camera are bent as a normal bends a surface's.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, .6, 0> angle 45 normal { bumps .2 scale .3 } }
light_source { <-6, 9, -8> rgb 1 }
sphere { <0, 1, 0>, 1 pigment { rgb <.9, .6, .3> } finish { ambient .1 diffuse .7 phong .4 } }
box { <-2.2, 0, -.4>, <-1.4, 1.4, .4> pigment { rgb <.3, .5, .8> } }
plane { y, 0 pigment { checker rgb .8, rgb <.3, .5, .3> } }
