// Mirrors whose reflection depends on the angle, on the ior, on the pigment, and on what they reflect.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb <0.5, 0.6, 0.7> }
camera { location <0, 0.5, -7> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
plane { y, -2.2 pigment { checker rgb 0.8 rgb <0.6, 0.3, 0.2> } }
sphere { <-3, 1.1, 0>, 0.9 pigment { rgb <0.8, 0.5, 0.2> } finish { diffuse 0.2 reflection { 0.1, 0.9 } } }
sphere { <-1, 1.1, 0>, 0.9 pigment { rgb <0.8, 0.5, 0.2> } finish { diffuse 0.2 reflection { 0, rgb <1, 0.8, 0.6> falloff 3 } } }
sphere { <1, 1.1, 0>, 0.9 pigment { rgb <0.8, 0.5, 0.2> } finish { diffuse 0.2 reflection { 0.05, 1 fresnel } } interior { ior 1.6 } }
sphere { <3, 1.1, 0>, 0.9 pigment { rgb <0.8, 0.5, 0.2> } finish { diffuse 0.2 reflection { 0.7 metallic } } }
sphere { <-2, -1.1, 0>, 0.9 pigment { rgb <0.8, 0.5, 0.2> } finish { diffuse 0.2 reflection { 0.7 exponent 0.5 } } }
sphere { <0, -1.1, 0>, 0.9 pigment { rgbf <1, 0.9, 0.8, 0.7> } finish { reflection { 0.1, 1 fresnel } conserve_energy } interior { ior 1.5 } }
sphere { <2, -1.1, 0>, 0.9 pigment { rgbt <1, 0.9, 0.8, 0.7> } finish { reflection 0.4 conserve_energy } }
