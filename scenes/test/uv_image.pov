// Images by the surfaces' own coordinates: sphere, box, torus, cylinder, and normals too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#declare P = pigment { uv_mapping image_map { png "images/rings.png" interpolate 2 } }
sphere { 0, 1 pigment { P } rotate <20, 40, 0> translate <-1.5, 1, 0> scale <1, .8, 1> }
box { -.9, <.7, .9, .8> texture { pigment { P } finish { phong .3 } } rotate <20, 30, 0> translate <1.4, .9, 0> }
torus { .9, .4 pigment { P } rotate x*-40 translate <-1.3, -1.1, 0> }
cylinder { -y, y, .6 pigment { uv_mapping image_map { gif "images/tiles.gif" } scale .5 } rotate x*20 translate <1.5, -1.1, 0> }
plane { z, 4 pigment { rgb .6 } normal { uv_mapping bump_map { png "images/grey16.png" interpolate 2 bump_size 3 } scale 3 } }
