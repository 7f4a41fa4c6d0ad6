// Polygons that need not be convex, in any plane; each shows both its sides.
camera { location <0, 1, -5> look_at <0, 0, 0> }
light_source { <2, 5, -6> color rgb <1, 1, 1> }
polygon { 6, <-2, -1, 0>, <-0.3, -1, 0>, <-0.3, 1, 0>, <-1.2, 0, 0>, <-2, 1, 0>, <-2, -1, 0>
    pigment { color rgb <0.9, 0.5, 0.3> } }
polygon { 5, <0.3, -1, -0.5>, <2, -1, 0.5>, <2, 0.5, 1>, <0.3, 0.5, 0>, <0.3, -1, -0.5>
    pigment { color rgb <0.4, 0.6, 0.9> } }
