// Straight down with a `right` towards -x: the written `right` turns the frame, and then mirrors it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, 0> right <-1.33, 0, 0> look_at 0 }
light_source { <4, 8, -3> rgb 1 }
box { <0.2, -1, -1.5>, <1.6, 0.5, 0.5> pigment { rgb <0.8, 0.5, 0.4> } }
sphere { <-1, 0, 1>, 0.7 pigment { rgb <0.4, 0.8, 0.5> } }
