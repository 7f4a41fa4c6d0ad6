// A paraboloid y = x^2 + z^2, endless upwards, seen from inside and outside.
camera { location <0, 3.5, -5> look_at <0, 1, 0> }
light_source { <3, 4, -8> color rgb <1, 1, 1> }
quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 pigment { color rgb <0.5, 0.8, 0.6> } }
