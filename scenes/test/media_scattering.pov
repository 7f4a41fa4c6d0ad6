// Two lights in a box of dust of two kinds, one of them behind a ball that throws its shadow through it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -6> look_at <0, 0, 0> angle 45 }
light_source { <-3, 4, 0.5> rgb <1, 0.8, 0.6> spotlight point_at <0.2, -0.4, 0> radius 10 falloff 16 }
light_source { <4, 3, 2> rgb <0.2, 0.3, 0.5> fade_distance 5 fade_power 2 }
plane { y, -1.2 hollow pigment { rgb 0.6 } }
box { <-1.8, -1, -1>, <1.8, 1.2, 1> hollow pigment { rgbt 1 }
      interior { media { scattering { 5, 0.25 eccentricity 0.3 } method 2 samples 60, 60 }
                 media { scattering { 1, 0.1 extinction 0.5 } method 2 samples 60, 60 } } }
sphere { <-0.6, 0.5, 0.1>, 0.25 pigment { rgb <0.9, 0.3, 0.2> } }
