// Bumps so high that some normals point into the surface: their mirrored rays go outward all the same.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -9> look_at 0 angle 30 }
sphere { 0, 1e4 hollow pigment { gradient y color_map { [0 rgb <.2, .1, .1>] [.5 rgb <.4, .6, .3>] [1 rgb <.6, .8, 1>] } scale 2e4 translate -1e4 } finish { ambient 1 diffuse 0 } no_shadow }
sphere { 0, 1 pigment { rgb .1 } normal { bumps 3 scale .4 } finish { reflection .8 diffuse 0 } translate -1.1*x }
sphere { 0, 1 pigment { rgb .1 } normal { dents 6 scale .5 } finish { reflection { .2, .9 falloff 2 } diffuse 0 } translate 1.1*x }
