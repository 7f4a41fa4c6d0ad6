// Layers with reflection, a map of textures, an average of textures, and another texture inside.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
background { rgb <0.5, 0.6, 0.7> }
camera { location <0, 1.5, -8> look_at <0, 0, 0> angle 50 }
light_source { <3, 8, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9 rgb <0.3, 0.4, 0.3> } }
sphere { <-2.6, 0, 0>, 0.9
  texture { pigment { rgb <0.8, 0.4, 0.2> } finish { reflection 0.3 } }
  texture { pigment { rgbft <0.5, 0.9, 0.6, 0.3, 0.4> } finish { specular 0.4 reflection 0.1 conserve_energy } } }
sphere { <-0.9, 0, 0>, 0.8
  texture { gradient x texture_map { [0.3 pigment { rgb <0.8, 0.2, 0.2> } finish { reflection 0.4 }] [0.7 pigment { rgbt <1, 1, 1, 0.8> }] } scale 1.6 translate -1.7*x } }
sphere { <0.9, 0, 0>, 0.8
  texture { average texture_map { [1 pigment { rgb <0.2, 0.3, 0.8> } finish { phong 0.8 }] [2 pigment { rgb <0.9, 0.8, 0.2> } finish { specular 0.5 }] } } }
sphere { <2.6, 0, 0>, 0.9 hollow texture { pigment { rgbt <0.2, 0.8, 0.4, 0.5> } } interior_texture { pigment { rgb <0.9, 0.2, 0.5> } finish { ambient 0.4 } } clipped_by { plane { -z, 0.6 } } }
