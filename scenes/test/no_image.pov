// Objects that the camera does not see, also through glass, and objects that mirrors do not see; both cast shadows.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.5, 0.6, 0.7> }
camera { location <0, 2, -7> look_at <0, 0.5, 0> }
light_source { <3, 8, -4> rgb 1 }
plane { y, -1 pigment { rgb 0.8 } }
box { <-3, -1, 2>, <3, 2, 2.1> pigment { rgb 0.2 } finish { reflection 0.7 } }
sphere { <-1.5, 0, 0>, 0.8 no_image pigment { rgb <1, 0.3, 0.1> } }
sphere { <1.5, 0, 0>, 0.8 no_reflection pigment { rgb <0.2, 0.7, 0.3> } }
sphere { <-1.5, 0.2, -2>, 0.5 pigment { rgbt <1, 1, 1, 0.8> } interior { ior 1.3 } }
