// Highlights and reflections are not weakened by how much a surface lets through.
camera { location <0, 1, -5> look_at <0, 0, 0> }
light_source { <4, 5, -5> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 1.2 pigment { color rgbf <1, 1, 1, 1> }
    finish { phong 0.7 phong_size 20 reflection 0.2 } }
box { <-4, -1.6, -4>, <4, -1.4, 5> pigment { color rgb <0.4, 0.6, 0.5> } }
