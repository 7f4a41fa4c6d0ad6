// A camera's transformations move its place and turn its frame.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at <0, 0, 0> rotate <20, 0, 15> translate <0.5, 0.2, 0> rotate <0, 30, 0> }
light_source { <4, 8, -8> rgb 1 }
box { <-1, -0.6, -0.6>, <1, 0.6, 0.6> pigment { rgb <0.9, 0.6, 0.5> } }
cone { <0, 0.6, 0>, 0.5, <0, 1.4, 0>, 0 pigment { rgb <0.5, 0.6, 0.9> } }
