// Cylinders with caps, upright and aslant.
camera { location <0, 2.5, -5> look_at <0, 0, 0> }
light_source { <-4, 6, -6> color rgb <1, 1, 1> }
cylinder { <-1.2, -1, 0>, <-1.2, 0.8, 0>, 0.7 pigment { color rgb <0.8, 0.5, 0.9> } }
cylinder { <0.4, -0.8, 0.5>, <1.8, 0.6, -0.7>, 0.5 pigment { color rgb <0.5, 0.9, 0.6> } }
