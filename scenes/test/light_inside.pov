// A light inside a coloured glass ball shines out through one surface; inside an opaque one it is shut in.
camera { location <0, 3, -7> look_at <0, 0, 0> }
light_source { <-1.6, 0.2, 0> color rgb <1, 1, 1> }
light_source { <1.6, 0.2, 0> color rgb <1, 1, 1> }
sphere { <-1.6, 0, 0>, 0.9 pigment { color rgbf <0.9, 0.5, 0.3, 0.9> } }
sphere { <1.6, 0, 0>, 0.9 pigment { color rgb <0.3, 0.5, 0.9> } }
box { <-5, -1.2, -2>, <5, -1, 4> pigment { color rgb <0.8, 0.8, 0.8> } }
