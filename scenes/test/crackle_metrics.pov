// Crackle with other metrics, other sums of distances, and its solid cells.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { crackle metric 1 } }
sphere { 0, 1 pigment { crackle metric 3 scale .4 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { crackle form <.8, -.6, .5> metric 1.5 offset .2 scale .4 } translate <0, .1, -1> }
sphere { 0, 1 pigment { crackle metric 4 solid scale .3 } normal { facets coords .3 scale 2 } finish { phong .4 } translate <2.3, .1, -1> }
