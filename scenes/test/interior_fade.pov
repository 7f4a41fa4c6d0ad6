// Light fades inside solids, for rays and for light on its way, with and without a colour; the last one focuses light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
background { rgb <0.5, 0.6, 0.7> }
camera { location <0, 2.5, -8> look_at <0, 0, 0> }
light_source { <3, 8, -4> rgb 1 }
plane { y, -1.5 pigment { checker rgb 0.9 rgb <0.6, 0.4, 0.3> } }
sphere { <-3, 0, 0>, 1 pigment { rgbt <1, 1, 1, 0.95> } interior { ior 1.4 fade_distance 0.5 fade_power 1 } }
sphere { <-1, 0, 0>, 0.9 pigment { rgbt <1, 1, 1, 0.95> } interior { ior 1.4 fade_distance 1 fade_power 2 fade_color rgb <0.2, 0.7, 0.9> } }
box { <0.2, -0.8, -0.8>, <1.8, 0.8, 0.8> rotate 20*y pigment { rgbt <1, 1, 1, 0.95> } interior { fade_distance 1 fade_power 1001 fade_color rgb <0.9, 0.5, 0.1> } }
sphere { <3.2, 0, 0>, 1 pigment { rgbf <0.9, 0.9, 1, 0.95> } interior { ior 1.5 caustics 0.6 } }
