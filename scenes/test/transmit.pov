// Transmit lets light through uncoloured, with filter or alone, in what is seen and in the shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0, 0> }
light_source { <1, 8, -3> rgb 1 }
sphere { <-1.5, 0, 0>, 0.9 pigment { rgbt <0.9, 0.3, 0.2, 0.6> } }
sphere { <1.5, 0, 0>, 0.9 pigment { rgbft <0.3, 0.9, 0.4, 0.4, 0.4> } }
box { <-5, -1.2, -3>, <5, -1, 5> pigment { rgb <0.8, 0.8, 0.9> } }
