// assumed_gamma 2.2: colours are decoded by that power before they are encoded for the file.
#version 3.6;
global_settings { assumed_gamma 2.2 }
camera { location <0, 0.5, -4> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
sphere { <0, 0, 0>, 1.2 pigment { rgb <0.9, 0.5, 0.25> } }
