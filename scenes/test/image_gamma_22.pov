// Images in a scene that calculates in another gamma.
#version 3.7;
global_settings { assumed_gamma 2.2 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#macro Tile(X, Y, P) box { 0, <1, 1, .01> pigment { P } finish { ambient 1 diffuse 0 } translate -.5 scale <2.8, 1.9, 1> translate <X, Y, 0> } #end
Tile(-1.5, 1, pigment { image_map { png "images/rings.png" } })
Tile(1.5, 1, pigment { image_map { ppm "images/rings.ppm" } })
Tile(-1.5, -1, pigment { image_map { png "images/tiles.png" gamma 1.8 } })
Tile(1.5, -1, pigment { image_pattern { png "images/rings.png" interpolate 2 } })
