// Pixels, and three methods of colours between them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#macro Tile(X, Y, P) box { 0, <1, 1, .1> pigment { P } finish { ambient 1 diffuse 0 } translate -.5 scale <2.8, 1.9, 1> translate <X, Y, 0> } #end
Tile(-1.5, 1, pigment { image_map { png "images/rings.png" } })
Tile(1.5, 1, pigment { image_map { png "images/rings.png" interpolate 2 } })
Tile(-1.5, -1, pigment { image_map { png "images/rings.png" interpolate 3 } })
Tile(1.5, -1, pigment { image_map { png "images/rings.png" interpolate 4 once } })
