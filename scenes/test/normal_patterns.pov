// Any pattern as a normal: its slope.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.5, .6, .7> } normal { gradient x .4 sine_wave scale 1.2 } finish { reflection .3 } }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { gradient y 1 sine_wave scale .3 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { granite .4 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <0, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { wood 1 turbulence .05 scale .4 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { leopard 1.5 scale .08 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { onion .7 sine_wave scale .3 translate <.2, .3, -.8> } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { agate .5 scale .7 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <2.3, .1, 1.2> }
