// Bumps so high that mirrored rays would go into the surface.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.5, .6, .7> } normal { gradient x 3 sine_wave scale .8 } finish { reflection .3 } }
sphere { 0, 1 pigment { rgb <.3, .2, .1> } normal { bumps 3 scale .2 } finish { reflection .8 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.3, .2, .1> } normal { dents 4 scale .15 } finish { reflection .8 } translate <0, .1, -1> }
sphere { 0, 1 pigment { rgbf .9 } normal { bumps 1 scale .3 } finish { reflection .2 phong .5 } interior { ior 1.3 } translate <2.3, .1, -1> }
