// A fisheye camera in a row of objects.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye angle 160 location <0, 1.5, -1> look_at <0, 1.2, 2> rotate 5*z }
light_source { <5, 8, -6> rgb 1 }
background { rgb <.3, .4, .6> }
plane { y, 0 pigment { checker rgb .8 rgb <.3, .5, .3> } }
sphere { <-2, 1, 1>, .7 pigment { rgb <.9, .3, .2> } }
box { <1.5, 0, -.5>, <2.5, 2, 1.5> pigment { rgb <.2, .4, .9> } }
cone { <0, 0, 3>, 1, <0, 3, 3>, 0 pigment { rgb <.9, .8, .2> } }
