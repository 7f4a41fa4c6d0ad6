// Without a camera the view is from the origin along +z, y up, a third wider than high.
light_source { <-5, 8, -3> color rgb <1, 1, 1> }
sphere { <0, 0, 6>, 1 pigment { color rgb <0.9, 0.5, 0.3> } }
box { <1.4, -1, 5>, <2.4, 1.6, 7> pigment { color rgb <0.4, 0.7, 0.9> } }
