// Matt layers with different finishes, maps and averages of matt textures, light through them; a glossy layer below.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 0.3 }
camera { location <0, 2, -6> look_at 0 angle 40 }
light_source { <5, 8, -6> rgb 1 }
light_source { <-5, 4, -6> rgb 0.3 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { <-1.2, 0, 0>, 1
  texture { pigment { granite color_map { [0 rgbt <0.9, 0.85, 0.7, 0.6>] [1 rgbt <0.1, 0.1, 0.2, 0.9>] } } finish { ambient 0.2 diffuse 0.7 } }
  texture { pigment { bozo turbulence 1 color_map { [0 rgbf <1, 0.8, 0.7, 0.9>] [1 rgbt <0.2, 0.2, 0.5, 0.3>] } scale 0.3 } finish { diffuse 0.3 emission 0.2 } }
  texture { pigment { checker rgbt <1, 0, 0, 0.7> rgbt 1 scale 0.4 } } }
sphere { <1.2, 0, 0>, 1
  texture { bozo texture_map { [0 pigment { rgb <1, 0.3, 0.2> } finish { diffuse 0.8 }] [0.5 pigment { granite }]
                               [1 pigment { rgb <0.1, 0.4, 0.9> } finish { ambient 0.5 }] } scale 0.4 } }
sphere { <0, 1.2, 0.5>, 0.6
  texture { average texture_map { [1 pigment { rgb <1, 0.3, 0.2> } finish { diffuse 0.8 }] [2 pigment { granite color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.2>] } }] } } }
sphere { <0, -0.6, -1.2>, 0.4
  texture { pigment { rgb <0.5, 0.6, 0.2> } finish { phong 1 } } texture { pigment { bozo color_map { [0 rgbt 1] [1 rgbt <0.2, 0.2, 0.5, 0.3>] } scale 0.3 } } }
