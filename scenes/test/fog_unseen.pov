// A ball that the camera does not see holds no fog up; its mirror image does.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
fog { distance 9 rgb <.6, .7, .9> }
plane { y, -1 pigment { checker rgb <.9, .8, .6> rgb .3 } }
sphere { <-1.4, .6, -2>, 1.2 pigment { rgbt 1 } no_image }
sphere { <1.4, .6, -2>, 1.2 pigment { rgbt 1 } }
box { <-3, -1, 3>, <3, 3, 3.2> pigment { rgb .2 } finish { reflection .7 } }
