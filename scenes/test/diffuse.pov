// Diffuse light: the cosine of the angle of incidence, at full, at half, and as it is by default.
camera { location <0, 0.5, -6> look_at <0, 0, 0> }
light_source { <3, 5, -6> color rgb <1, 1, 1> }
sphere { <-2, 0, 0>, 0.9 pigment { color rgb <0.9, 0.9, 0.9> } finish { diffuse 1 } }
sphere { <0, 0, 0>, 0.9 pigment { color rgb <0.9, 0.9, 0.9> } finish { diffuse 0.3 } }
sphere { <2, 0, 0>, 0.9 pigment { color rgb <0.9, 0.9, 0.9> } }
