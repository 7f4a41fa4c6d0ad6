// A matrix gives the images of x, y, z and of the origin, in this order: here a shear with a shift.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0, 0> }
light_source { <4, 8, -8> rgb 1 }
box { -0.6, 0.6 matrix <1, 0, 0, 0.7, 1, 0.2, 0, -0.3, 1.2, -1.3, 0.23, 0.5> pigment { rgb <0.9, 0.7, 0.4> } }
sphere { 0, 0.8 matrix <0, 1.2, 0, -0.5, 0, 0.4, 0.3, 0, 1, 1.3, 0, 0> pigment { rgb <0.5, 0.7, 0.9> } }
