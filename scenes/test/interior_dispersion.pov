// Dispersion: red light is bent less than violet light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb 0.1 }
camera { location <0, 1.5, -7> look_at <0, 0.5, 0> angle 40 }
light_source { <3, 8, -4> rgb 1 }
plane { y, -1 pigment { checker rgb 0.95 rgb 0.1 } }
sphere { <-1.2, 0.3, 0>, 1.1 pigment { rgbt <1, 1, 1, 0.95> } interior { ior 1.5 dispersion 1.1 dispersion_samples 12 } }
box { <0.4, -0.6, -0.6>, <1.8, 1.2, 0.6> rotate <0, 40, 10> pigment { rgbt <1, 1, 1, 0.95> } finish { reflection 0.1 } interior { ior 1.4 dispersion 1.15 } }
