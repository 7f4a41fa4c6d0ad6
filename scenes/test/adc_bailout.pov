// A ray whose weight has fallen below adc_bailout is not followed: of the mirrors' pictures only the second
// is left.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 adc_bailout 0.2 }
camera { location <-1, 0.5, -1.5> look_at <0.4, 0, 2> }
light_source { <0, 2.5, 0> rgb 1 }
box { <-4, -3, 3>, <4, 3, 3.2> pigment { rgb <0.4, 0.2, 0.2> } finish { ambient 0.5 reflection 0.5 } }
box { <-4, -3, -3.2>, <4, 3, -3> pigment { rgb <0.2, 0.2, 0.4> } finish { ambient 0.5 reflection 0.5 } }
sphere { <0.6, -0.4, 1>, 0.6 pigment { rgb <0.8, 0.7, 0.3> } }
