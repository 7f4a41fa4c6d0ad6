// Normals of objects that were turned and scaled after their texture was written.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.5, .6, .7> } normal { gradient x .5 sine_wave rotate y*30 scale 1.5 } finish { reflection .3 } }
#declare Bumpy = texture { pigment { rgb <.8, .7, .6> } normal { gradient y 1 sine_wave scale .25 } finish { phong .6 reflection .2 } }
sphere { 0, 1 texture { Bumpy } rotate <30, 20, 60> translate <-2.3, .1, 0> }
sphere { 0, 1 texture { Bumpy rotate z*40 scale <.6, 2, 1> } scale <.6, 1.2, 1> rotate z*30 translate <0, .2, 0> }
box { -1, 1 texture { pigment { rgb <.6, .8, .6> } normal { bumps 1 scale .2 } rotate 40 translate .3 } scale <.7, .9, .7> rotate y*30 translate <2.3, 0, 0> }
