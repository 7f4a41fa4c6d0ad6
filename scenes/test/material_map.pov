// Textures chosen by the palette of an image.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
plane { z, 2 texture { material_map { png "images/tiles.png" texture { pigment { rgb <.8, .2, .1> } } texture { pigment { checker rgb 1, rgb 0 scale .1 } } texture { pigment { rgb <.1, .5, .2> } finish { phong .8 } } texture { pigment { rgb <.2, .3, .9> } finish { reflection .4 } } } scale 4 translate -2 } }
sphere { <0, -.5, 0>, 1 texture { material_map { gif "images/tiles.gif" map_type 1 texture { pigment { rgb .9 } } texture { pigment { rgb <.9, .5, .1> } } } rotate y*70 } }
