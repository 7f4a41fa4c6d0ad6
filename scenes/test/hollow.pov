// hollow says that the inside is empty of media: surface, shadow and refraction stay as they are.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at <0, 0, 0> }
light_source { <3, 8, -6> rgb 1 }
sphere { <-1.1, 0, 0>, 1 hollow pigment { rgbf <1, 0.9, 0.8, 0.9> } interior { ior 1.4 } }
sphere { <1.1, 0, 0>, 1 hollow pigment { rgb <0.5, 0.6, 0.9> } }
box { <-6, -1.3, -4>, <6, -1.1, 9> pigment { rgb <0.5, 0.7, 0.5> } }
