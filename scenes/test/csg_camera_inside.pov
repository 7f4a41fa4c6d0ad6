// The camera is inside both members of a glass union, and leaves one after the other.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 0, -0.2> look_at <1, 0.2, 3> angle 80 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
union { sphere { <0, 0, 0>, 1 } box { <-0.5, -0.5, -0.5>, <1.5, 1.5, 1.5> } sphere { <-3,0,5>,1 } pigment { color rgbf <0.8, 1, 0.9, 0.9> } interior { ior 1.5 } }
box { <-3, -0.8, 3.5>, <3, -0.4, 4> pigment { color rgb <1, 0.3, 0.2> } }
box { <-9, -3.2, -9>, <9, -3, 9> pigment { color rgb 0.7 } }
