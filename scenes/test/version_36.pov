// Before 3.7 a surface keeps 1 - filter * max(r, g, b) - transmit of its ambient and diffuse light.
#version 3.6;
global_settings { ambient_light rgb 0.5 }
camera { location <0, 0.5, -4> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
sphere { <0, 0, 0>, 1.2 pigment { rgbft <0.5, 0.3, 0.2, 0.6, 0.1> } }
