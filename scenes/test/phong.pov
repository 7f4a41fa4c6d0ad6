// Highlights: the default size 40, a wide one, and a narrow strong one.
camera { location <0, 0.5, -6> look_at <0, 0, 0> }
light_source { <3, 5, -6> color rgb <1, 1, 1> }
sphere { <-2, 0, 0>, 0.9 pigment { color rgb <0.7, 0.2, 0.2> } finish { phong 0.7 } }
sphere { <0, 0, 0>, 0.9 pigment { color rgb <0.2, 0.6, 0.2> } finish { phong 0.5 phong_size 5 } }
sphere { <2, 0, 0>, 0.9 pigment { color rgb <0.2, 0.2, 0.7> } finish { phong 1 phong_size 200 diffuse 0.3 } }
