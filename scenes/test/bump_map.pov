// Bumps from an image: brightness, and entries of a palette.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
plane { z, 2 pigment { rgb <.8, .75, .6> } normal { bump_map { png "images/rings.png" interpolate 2 bump_size 8 } scale 3 translate -1.5 } }
sphere { <-1.4, 0, 0>, 1.2 pigment { rgb .9 } finish { phong .6 } normal { bump_map { png "images/grey16.png" map_type 1 interpolate 2 } bump_size 6 } }
box { <.3, -1, -.8>, <2.3, 1, .6> pigment { rgb <.6, .7, .9> } normal { bump_map { png "images/tiles.png" use_index bump_size .5 } scale 1.5 } rotate y*20 }
