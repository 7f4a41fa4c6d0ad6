// Hyperboloids of one sheet (left) and of two (right), both endless.
camera { location <0, 1, -9> look_at <0, 0, 0> }
light_source { <3, 4, -9> color rgb <1, 1, 1> }
quadric { <1, -0.6, 1>, <0, 0, 0>, <0, 0, 0>, -0.3 translate <-2, 0, 0>
    pigment { color rgb <0.9, 0.7, 0.3> } }
quadric { <2, -1, 2>, <0, 0, 0>, <0, 0, 0>, 0.4 translate <2.2, 0, 0> pigment { color rgb <0.3, 0.6, 0.9> } }
