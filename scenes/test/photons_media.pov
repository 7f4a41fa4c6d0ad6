// Beams that a ball of glass and a mirror throw into dust.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.02 autostop 0 media 100 } }
camera { location <0, 2.5, -7> look_at <0, 0.4, 0> angle 45 }
light_source { <0, 0.5, -60> rgb 0.9 spotlight point_at <0, 0.5, 0> radius 0.7 falloff 0.8 photons { refraction on reflection on } rotate 60*y }
plane { y, -1 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.5 } }
box { <-3, -0.95, -2.5>, <3, 2, 3> hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
      interior { media { scattering { 1, 0.3 extinction 0 } method 2 samples 40, 40 } } photons { target } }
sphere { <-0.6, 0.5, 0>, 0.6 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0 } interior { ior 1.4 } photons { target collect off } }
box { <1.4, -0.6, -0.8>, <1.5, 1.4, 0.8> pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.8 } rotate 20*y photons { target collect off } }
