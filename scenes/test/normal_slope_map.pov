// Slope maps: heights and slopes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { rgb <.5, .6, .7> } normal { gradient x 1 slope_map { [0 <0, 1>] [.5 <1, 1>] [.5 <1, -1>] [1 <0, -1>] } } finish { reflection .3 } }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { gradient y 1.5 slope_map { [0 <0, 1>] [.5 <1, 0>] [1 <0, -1>] } scale .4 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { wood 1 slope_map { [0 <0, .5>] [.5 <.5, .5>] [.5 <.5, 0>] [1 <.5, 0>] } scale .5 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <0, .1, -1> }
sphere { 0, 1 pigment { rgb <.8, .7, .6> } normal { bozo 1 slope_map { [.2 <0, 0>] [.6 <.7, 0>] [.8 <.7, 0>] } scale .3 } finish { ambient 0 diffuse .5 reflection .4 phong .6 phong_size 60 } translate <2.3, .1, -1> }
