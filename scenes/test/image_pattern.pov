// The brightness of an image, and its alpha, as the values of maps.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#declare M = color_map { [0 rgb <0, 0, .4>] [.5 rgb <.2, .7, .5>] [1 rgb <1, .9, .6>] }
plane { z, 3 pigment { image_pattern { png "images/grey16.png" interpolate 3 } color_map { M } scale 2 } }
sphere { <-1.5, 0, 0>, 1.2 pigment { image_pattern { png "images/rings.png" map_type 1 } color_map { M } frequency 2 } }
box { <.3, -1, -.5>, <2.3, 1, .5> pigment { image_pattern { png "images/petals.png" use_alpha interpolate 2 } color_map { M } } rotate y*15 }
