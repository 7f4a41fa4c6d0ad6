// With no squares a quadric is a plane, with one a pair of planes, with two a cylinder.
camera { location <1, 2, -6> look_at <0, 0.5, 0> }
light_source { <4, 8, -6> color rgb <1, 1, 1> }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 1 pigment { color rgb <0.5, 0.6, 0.5> } }
quadric { <0, 0, 1>, <0, 0, 0>, <0, 0, 0>, -64 pigment { color rgb <0.4, 0.5, 0.8> } }
quadric { <1, 0, 0.5>, <0, 0, 0>, <0, 0, 0>, -0.6 pigment { color rgb <0.9, 0.6, 0.5> } }
