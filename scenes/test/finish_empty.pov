// An empty finish is the default one; items may come in several blocks, and no pigment means black.
camera { location <0, 0.5, -6> look_at <0, 0, 0> }
light_source { <3, 5, -6> color rgb <1, 1, 1> }
sphere { <-2, 0, 0>, 0.9 pigment { color rgb <0.9, 0.6, 0.3> } finish { } }
sphere { <0, 0, 0>, 0.9 finish { diffuse 0.9 } pigment { color rgb <0.5, 0.9, 0.5> } finish { phong 0.4 } }
sphere { <2, 0, 0>, 0.9 finish { phong 0.9 phong_size 3 } }
