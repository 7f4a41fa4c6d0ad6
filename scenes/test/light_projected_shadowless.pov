// Light without shadows shines through a hole all the same.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
background { rgb <.3, .5, .8> }
light_source { <4, 9, -5> rgb .9 shadowless projected_through { disc { <2, 4.2, -2.5>, y, .6 } } }
light_source { <-6, 9, -4> rgb <.2, .2, .3> }
plane { y, -1 pigment { rgb <.9, .8, .6> } }
sphere { <0, .4, -.5>, .8 pigment { rgb <.9, .3, .2> } finish { phong .5 } }
