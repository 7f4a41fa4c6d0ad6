// A ball that takes light apart, lit by the points of an area light.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.008 autostop 0 max_trace_level 6 } }
camera { location <0, 3.4, -2.4> look_at <0.5, 0, 0.2> angle 50 }
light_source { <-5, 6, 0> rgb 0.5 area_light 0.6*x, 0.6*z, 3, 3 photons { area_light refraction on } }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 0.7 } }
sphere { <-0.2, 1.5, 0>, 0.9 pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
         interior { ior 1.45 dispersion 1.1 dispersion_samples 10 } photons { target } }
