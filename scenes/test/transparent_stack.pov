// Straight transmission does not count for the depth: through ten panes and a ball of ior 1 the wall is still
// seen.
camera { location <0, 0, -6> look_at <0, 0, 0> }
light_source { <0, 3, -8> color rgb <1, 1, 1> }
box { <-0.9, -0.9, -1.0>, <0.9, 0.9, -0.9> pigment { color rgbf <0.98, 1, 1, 0.95> } }
box { <-1.0, -0.9, -0.5>, <1.0, 0.9, -0.4> pigment { color rgbf <0.98, 1, 1, 0.95> } }
box { <-1.1, -0.9, 0.0>, <1.1, 0.9, 0.1> pigment { color rgbf <0.98, 1, 1, 0.95> } }
box { <-1.2, -0.9, 0.5>, <1.2, 0.9, 0.6> pigment { color rgbf <0.98, 1, 1, 0.95> } }
sphere { <0, 0, 2>, 0.7 pigment { color rgbf <1, 0.8, 0.6, 0.9> } interior { ior 1 } }
box { <-3, -2, 4>, <3, 2, 4.2> pigment { color rgb <0.9, 0.8, 0.5> } finish { diffuse 1 } }
