// Cones with caps: pointed, cut off, and widening along the axis.
camera { location <0, 2.5, -5> look_at <0, 0, 0> }
light_source { <-4, 6, -6> color rgb <1, 1, 1> }
cone { <-1.5, -1, 0>, 0.8, <-1.5, 1, 0>, 0 pigment { color rgb <0.9, 0.3, 0.3> } }
cone { <0.2, -1, 0>, 0.7, <0.2, 0.6, 0>, 0.4 pigment { color rgb <0.3, 0.9, 0.3> } }
cone { <1, -0.6, 0>, 0.2, <2.2, 0.4, -0.5>, 0.6 pigment { color rgb <0.4, 0.4, 0.9> } }
