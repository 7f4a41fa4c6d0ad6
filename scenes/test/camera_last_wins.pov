// Of several cameras the last one counts.
camera { location <0, 0, -20> look_at <5, 0, 0> }
light_source { <4, 8, -8> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 1 pigment { color rgb <0.5, 0.8, 0.6> } }
camera { location <1, 1, -4> look_at <0, 0, 0> }
