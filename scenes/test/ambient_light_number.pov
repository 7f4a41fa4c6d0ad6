// `ambient_light` and a finish's ambient may be numbers or colours; light_source, background and pigment take
// colours too.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light 0.8 }
camera { location <0, 0, -5> look_at <0, 0, 0> }
background { rgb 0.2 }
sphere { <-1.2, 0, 0>, 1 pigment { rgb <0.5, 0.9, 0.7> } finish { ambient 0.9 diffuse 0 } }
sphere { <1.2, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient rgb <0.2, 0.5, 0.8> diffuse 0 } }
