// The formats, with and without a gamma of their own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#macro Tile(X, Y, P) box { 0, <1, 1, .01> pigment { P } finish { ambient 1 diffuse 0 } translate -.5 scale <2, 1.9, 1> translate <X, Y, 0> } #end
Tile(-2.1, 1, pigment { image_map { tga "images/rings.tga" } })
Tile(0, 1, pigment { image_map { ppm "images/rings.ppm" } })
Tile(2.1, 1, pigment { image_map { png "images/grey16.png" interpolate 2 } })
Tile(-2.1, -1, pigment { image_map { png "images/rings.png" gamma 1.4 } })
Tile(0, -1, pigment { image_map { ppm "images/rings.ppm" gamma srgb } })
Tile(2.1, -1, pigment { image_map { "images/rings.png" gamma 1 } })
