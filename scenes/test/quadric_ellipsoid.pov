// A quadric with all squares positive and mixed terms: a tilted ellipsoid.
camera { location <0, 1, -5> look_at <0, 0, 0> }
light_source { <5, 6, -6> color rgb <1, 1, 1> }
quadric { <1, 2, 1.5>, <0.8, 0.3, -0.4>, <0.2, -0.5, 0>, -1.2 pigment { color rgb <0.9, 0.5, 0.5> } }
