// The scene with settings of POV-Ray's that it needs to come to the same picture (../README.md).
// Densities: a cloud by a map of bozo, moved with its object; a ball by two densities that multiply.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.3, -6> look_at <0, 0, 0> angle 45 }
background { rgb <0.3, 0.4, 0.6> }
plane { z, 4 hollow pigment { rgb <0.5, 0.6, 0.8> } finish { ambient 1 diffuse 0 } }
sphere { 0, 1 hollow pigment { rgbt 1 }
         interior { media { emission 0.7 absorption 1.5 method 3 samples 600, 600
                            density { bozo turbulence 0.4 scale 0.5
                                      density_map { [0.3 rgb 0] [0.6 rgb <1, 0.8, 0.5>] [1 rgb 2] } }
                            density { spherical } } }
         scale <1.2, 0.9, 1> rotate 20*z translate <-1, 0, 0> }
sphere { 0, 1 hollow pigment { rgbt 1 }
         interior { media { emission <0.2, 0.5, 0.9> method 3 samples 600, 600 density { spherical } density { gradient y translate -0.5*y } } }
         translate <1.2, 0, 0> }
