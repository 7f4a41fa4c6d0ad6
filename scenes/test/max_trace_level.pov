// Between two mirrors the picture ends after max_trace_level rays: here the fourth sees black.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <-1, 0.5, -1.5> look_at <0.4, 0, 2> }
light_source { <0, 2.5, 0> rgb 1 }
box { <-4, -3, 3>, <4, 3, 3.2> pigment { rgb <0.2, 0.1, 0.1> } finish { ambient 0.5 reflection 0.9 } }
box { <-4, -3, -3.2>, <4, 3, -3> pigment { rgb <0.1, 0.1, 0.2> } finish { ambient 0.5 reflection 0.9 } }
sphere { <0.6, -0.4, 1>, 0.6 pigment { rgb <0.8, 0.7, 0.3> } }
