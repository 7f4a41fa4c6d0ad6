// An image on a plane, a sphere, a cylinder and a torus; once and repeated.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
plane { z, 3 pigment { image_map { png "images/rings.png" } } }
box { <-.5, -.5, 0>, <2.5, 1.5, .1> pigment { image_map { png "images/rings.png" once } } translate <-3, .8, 0> scale .9 }
sphere { 0, .9 pigment { image_map { png "images/rings.png" map_type 1 } rotate y*50 } translate <1.8, 1, 0> }
cylinder { -y, y, .7 pigment { image_map { png "images/rings.png" map_type 2 interpolate 2 } rotate y*160 } translate <-1.8, -1, 0> }
torus { 1, .5 pigment { image_map { png "images/rings.png" map_type 5 interpolate 2 } } rotate x*-40 translate <1.5, -1, 0> }
