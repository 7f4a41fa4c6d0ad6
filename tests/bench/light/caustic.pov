// A ball and a rod of glass that gather light on a floor. POV-Ray's setting: Spacing, of its photons.
#version 3.7;
#ifndef (Spacing) #declare Spacing = 0.003; #end
global_settings { assumed_gamma 1 max_trace_level 8 photons { spacing Spacing autostop 0 } }
camera { location <0, 4, -5> look_at <0.2, 0, 0> angle 48 }
light_source { <-3, 7, 3> rgb 0.4 }
plane { y, 0 pigment { rgb 1 } finish { ambient 0.05 diffuse 0.8 } }
#default { pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0 } }
sphere { <-0.8, 0.9, 0>, 0.8 interior { ior 1.5 } photons { target refraction on } }
cylinder { <0.7, 0.5, -1>, <1.3, 0.5, 1.2>, 0.45 interior { ior 1.4 } photons { target refraction on } }
