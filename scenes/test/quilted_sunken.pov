// Controls below 0: cushions are as high as they are deep.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { quilted control0 -1 color_map { [0 rgb .1] [1 rgb <.9, .8, .6>] } } }
sphere { 0, 1 pigment { quilted control0 -1.5 scale .5 } translate <-1.3, .1, -1> }
sphere { 0, 1 pigment { rgb <.9, .5, .3> } normal { quilted 1.5 control0 -.6 control1 .4 scale .5 } translate <1.3, .1, -1> }
