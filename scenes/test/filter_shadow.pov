// Shadows through coloured filters are coloured, twice by a box and once by a polygon; behind two they
// multiply.
camera { location <0, 3, -7> look_at <0, 0, 0> }
light_source { <0, 9, -2> color rgb <1, 1, 1> }
box { <-2, 1, -1>, <0.3, 1.1, 1> pigment { color rgbf <1, 0.6, 0.5, 0.9> } }
polygon { 5, <-0.3, 1.5, -0.6>, <2, 1.5, -0.6>, <2, 1.5, 1.3>, <-0.3, 1.5, 1.3>, <-0.3, 1.5, -0.6>
    pigment { color rgbf <0.4, 0.7, 1, 0.8> } }
box { <-5, -1.2, -3>, <5, -1, 5> pigment { color rgb <0.9, 0.9, 0.9> } }
