// Light through a perturbed surface is focused where the surface's normal points at the light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,6,-12> look_at <0,0,1> angle 50 }
light_source { <2,30,-3> rgb .8 }
plane { y, 0 pigment { rgb .6 } finish { ambient .1 diffuse .7 } }
plane { y, 10 hollow pigment { rgbf <.7,.8,1,.9> } interior { ior 1.1 caustics .8 } normal { bumps .5 scale 2 } }
sphere { <-2,1,0>, 1 pigment { rgb <.9,.3,.2> } }
