// Two lights add up, each with its own shadow.
camera { location <0, 4, -6> look_at <0, 0, 0> }
light_source { <-5, 6, -3> color rgb <0.8, 0.4, 0.3> }
light_source { <5, 6, -4> color rgb <0.3, 0.5, 0.8> }
sphere { <0, 0.2, 0>, 1 pigment { color rgb <0.9, 0.9, 0.9> } }
box { <-4, -1, -3>, <4, -0.8, 4> pigment { color rgb <0.8, 0.8, 0.8> } }
