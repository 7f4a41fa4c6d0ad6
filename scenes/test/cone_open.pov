// An open cone has no caps: its inside is seen, and light falls through it.
camera { location <0, 3, -4> look_at <0, 0, 0> }
light_source { <2, 8, -3> rgb 1 }
cone { <0, 0.8, 0>, 1.2, <0, -0.8, 0>, 0.4 open pigment { rgb <0.9, 0.6, 0.2> } }
box { <-4, -1.2, -4>, <4, -1, 4> pigment { rgb 0.8 } }
