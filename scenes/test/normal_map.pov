// Normals that are mixed: maps and averages of them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.5, .6, .7> } normal { checker normal { bumps .8 scale .2 }, normal { ripples .6 scale .5 } } finish { reflection .3 } }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { gradient y normal_map { [.3 bumps 1 scale .1] [.7 ripples 1 frequency 3] } scale 1.3 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { average normal_map { [1 gradient x 2 sine_wave scale .3] [2 gradient y 2 sine_wave scale .3] } } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <0, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { bozo normal_map { [.4 wrinkles 1 scale .3] [.45 bumps 0] } scale .6 rotate 30 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <2.3, .1, -1> }
