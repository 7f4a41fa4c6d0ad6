// Diffuse light: brilliance, albedo, light from behind by a second value and by double_illuminate, and a thin film.
#version 3.7;
global_settings { assumed_gamma 1 irid_wavelength rgb <0.65, 0.5, 0.4> }
camera { location <0, 0.5, -7> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
sphere { <-3, 1.1, 0>, 0.9 pigment { rgb <0.2, 0.6, 0.3> } finish { diffuse 0.8 brilliance 4 } }
sphere { <-1, 1.1, 0>, 0.9 pigment { rgb <0.2, 0.6, 0.3> } finish { diffuse albedo 0.3 brilliance 2.5 } }
sphere { <1, 1.1, 0>, 0.9 pigment { rgb <0.2, 0.6, 0.3> } finish { diffuse 0.6, 0.4 } no_shadow }
sphere { <3, 1.1, 0>, 0.9 pigment { rgb <0.2, 0.6, 0.3> } finish { specular 0.5 } double_illuminate no_shadow }
sphere { <-1, -1.1, 0>, 0.9 pigment { rgb 0.7 } finish { irid { 0.5 thickness 0.6 } phong 0.4 } }
sphere { <1, -1.1, 0>, 0.9 pigment { rgb <0.2, 0.6, 0.3> } finish { ambient 0 emission rgb <0.3, 0.1, 0> } }
