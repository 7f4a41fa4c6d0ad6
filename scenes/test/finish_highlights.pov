// Specular highlights of three sizes, one of a metal, and one beside a phong highlight.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -7> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
sphere { <-3, 1.1, 0>, 0.9 pigment { rgb <0.2, 0.3, 0.6> } finish { specular 0.8 } }
sphere { <-1, 1.1, 0>, 0.9 pigment { rgb <0.2, 0.3, 0.6> } finish { specular 0.8 roughness 0.3 } }
sphere { <1, 1.1, 0>, 0.9 pigment { rgb <0.2, 0.3, 0.6> } finish { specular 0.8 roughness 0.004 } }
sphere { <3, 1.1, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { specular 0.8 roughness 0.1 metallic } }
sphere { <-2, -1.1, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { specular albedo 0.1 roughness 0.07 } }
sphere { <0, -1.1, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { specular 0.4 phong 0.4 phong_size 90 } }
sphere { <2, -1.1, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { phong albedo 0.05 phong_size 17.5 } }
