// A volume: its voxels, linear and cubic between them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
#macro Cut(X, I) box { <.13, .13, .45>, <.87, .87, .9> pigment { density_file df3 "images/blob.df3" interpolate I color_map { [0 rgb <0, 0, .3>] [.5 rgb <.9, .3, 0>] [1 rgb <1, 1, .7>] } } finish { ambient 1 diffuse 0 } translate -.5 scale 2.6 translate x*X } #end
Cut(-2.2, 0)
Cut(0, 1)
Cut(2.2, 2)
