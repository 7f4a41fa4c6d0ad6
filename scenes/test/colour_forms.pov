// Colours in all their forms.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -6> look_at 0 }
light_source { <2, 4, -8> colour red 1 green 0.9 blue 0.8 }
background { color rgb <0.1, 0.15, 0.2> }
sphere { <-2.2, 1, 0>, 0.8 pigment { rgb <0.9, 0.5, 0.2> } }
sphere { <0, 1, 0>, 0.8 pigment { color rgbf <0.4, 0.9, 0.5, 0.3> } }
sphere { <2.2, 1, 0>, 0.8 pigment { colour rgbt <0.5, 0.5, 0.9, 0.3> } }
sphere { <-2.2, -1, 0>, 0.8 pigment { rgbft <0.9, 0.9, 0.4, 0.2, 0.3> } }
sphere { <0, -1, 0>, 0.8 pigment { color red 0.8 blue 0.6 filter 0.2 } }
sphere { <2.2, -1, 0>, 0.8 pigment { color rgb <0.3, 0.8, 0.8> transmit 0.4 } }
