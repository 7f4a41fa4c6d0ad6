// Filter and transmit together over 1 amplify what is behind, and take the ambient and diffuse light away.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -5> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
background { rgb <0.3, 0.35, 0.4> }
sphere { <0, 0, 0>, 1.2 pigment { rgbft <0.9, 0.8, 0.7, 0.7, 0.6> } }
