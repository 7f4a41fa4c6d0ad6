// Boxes by two corners, which may be given in any order.
camera { location <2.5, 2, -4> look_at <0, 0, 0> }
light_source { <1, 6, -6> color rgb <1, 1, 1> }
box { <-1, -0.5, -0.5>, <0.2, 0.5, 0.5> pigment { color rgb <0.9, 0.8, 0.3> } }
box { <1.3, 0.9, 0.6>, <0.5, -0.7, -0.4> pigment { color rgb <0.3, 0.5, 0.9> } }
