// An atmosphere that ends at a wall and is left out in glass that is not hollow; one lamp is dimmed by it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -6> look_at <0, 0, 0> angle 45 }
light_source { <-4, 5, -3> rgb <0.8, 0.7, 0.6> media_attenuation on }
light_source { <4, 5, -3> rgb <0.2, 0.3, 0.5> media_interaction off }
plane { y, -1 hollow pigment { checker rgb 0.8 rgb 0.3 } }
plane { z, 9 hollow pigment { rgb <0.4, 0.5, 0.7> } }
media { scattering { 2, 0.02 extinction 1 } method 2 samples 60, 60 }
sphere { <-0.9, 0, 0>, 0.9 pigment { rgbt <1, 1, 1, 0.9> } interior { ior 1 } }
sphere { <1.1, 0, 0.5>, 0.9 hollow pigment { rgbt <1, 1, 1, 0.9> } interior { ior 1 } }
