// In the course dialect a metallic highlight is the light times 1 + m (pigment - 1), at every angle.
camera { location <0, 0.5, -6> look_at <0, 0, 0> }
light_source { <3, 5, -2> color rgb <1, 1, 1> }
sphere { <-1.2, 0, 0>, 1 pigment { color rgb <0.9, 0.6, 0.2> } finish { phong 0.8 phong_size 8 metallic 1 } }
sphere { <1.2, 0, 0>, 1 pigment { color rgb <0.9, 0.6, 0.2> } finish { phong 0.8 phong_size 8 metallic 0.5 } }
