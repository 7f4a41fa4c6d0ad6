// Colours when none are given: fractals, and the parts of an object.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { mandel 30 rotate 90*x scale 2 } }
sphere { 0, 1 pigment { julia <.353, .288>, 30 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { magnet 2 mandel 20 scale .5 } translate <0, .1, -1> }
sphere { 0, 1 pigment { object { torus { .7, .3 rotate 90*x } } } translate <2.3, .1, -1> }
