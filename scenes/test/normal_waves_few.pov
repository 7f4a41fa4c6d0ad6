// Waves from three sources by number_of_waves.
#version 3.7;
global_settings { assumed_gamma 1 number_of_waves 3 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.5, .6, .7> } normal { waves .6 scale .8 } finish { reflection .3 } }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { ripples 1 scale .3 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { waves 1 scale .3 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <0, .1, -1> }
