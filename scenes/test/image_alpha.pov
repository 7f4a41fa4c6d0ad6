// What images let through: alpha, palettes, filter and transmit of all and of an entry.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
plane { z, 2 pigment { checker rgb .9, rgb <.2, .3, .4> scale .37 } }
#macro Tile(X, Y, P) box { 0, <1, 1, .01> pigment { P } finish { ambient 1 diffuse 0 } translate -.5 scale <2, 1.9, 1> translate <X, Y, 0> } #end
Tile(-2.1, 1, pigment { image_map { png "images/petals.png" } })
Tile(0, 1, pigment { image_map { png "images/petals.png" transmit all .3 interpolate 2 } })
Tile(2.1, 1, pigment { image_map { png "images/tiles.png" } })
Tile(-2.1, -1, pigment { image_map { gif "images/tiles.gif" filter 1, .8 transmit 3, .6 } })
Tile(0, -1, pigment { image_map { png "images/rings.png" filter all .7 } })
Tile(2.1, -1, pigment { image_map { png "images/tiles.png" filter all .3 transmit 0, .5 } })
