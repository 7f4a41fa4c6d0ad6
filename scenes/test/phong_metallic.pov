// Metallic highlights take the pigment's colour, less so where the light grazes; by half, and a plain one
// beside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -6> look_at <0, 0, 0> }
light_source { <3, 5, -2> rgb 1 }
sphere { <-2, 0, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.8 phong_size 8 metallic } }
sphere { <0, 0, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.8 phong_size 8 metallic 0.5 } }
sphere { <2, 0, 0>, 0.9 pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.8 phong_size 8 } }
