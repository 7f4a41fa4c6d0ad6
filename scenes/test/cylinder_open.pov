// An open cylinder is a tube: seen from its end, lit on its inside.
camera { location <1.5, 1, -4> look_at <0, 0, 0> }
light_source { <2, 3, -8> rgb 1 }
cylinder { <0, 0, -1>, <0, 0, 1.5>, 1 open pigment { rgb <0.4, 0.7, 0.9> } }
cylinder { <-2, -1.6, 1>, <2, -1.6, 1>, 0.3 pigment { rgb <0.9, 0.7, 0.4> } }
