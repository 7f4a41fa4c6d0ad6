// Bumps, dents and wrinkles, and their sizes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.5, .6, .7> } normal { bumps .3 scale .5 } finish { reflection .3 } }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { bumps scale .2 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { bumps .8 scale .3 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <0, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { dents 1 scale .2 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { dents .6 noise_generator 1 scale .15 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { wrinkles scale .6 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { wrinkles .3 scale <1, .2, 1> } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <2.3, .1, 1.2> }
