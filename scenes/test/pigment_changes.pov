// A pigment that begins with another, or stands behind one, changes it: transformations, turbulence, waves and maps remain.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#declare P = pigment { cells color_map { [0 rgb x] [.5 rgb 1] [1 rgb y] } frequency 3 phase .2 scale .3 }
#declare S = pigment { crackle color_map { [0 rgb z] [.5 rgb 1] [1 rgb y] } sine_wave turbulence .4 scale .4 }
#declare T = texture { pigment { checker rgb x, rgb 1 scale .3 rotate 30 } finish { phong 1 } }
plane { y, -1 pigment { rgb .8 } }
sphere { <-2.2, -.2, 0>, .7 pigment { P checker rgb 1, rgb 0 } }
sphere { <-.7, -.2, 0>, .7 pigment { P crackle } }
sphere { <.7, -.2, 0>, .7 pigment { P marble frequency 1 } }
sphere { <2.2, -.2, 0>, .7 pigment { S cells ramp_wave } }
sphere { <-2.2, 1.3, 0>, .7 pigment { S hexagon rgb x, rgb y, rgb 1 ramp_wave } }
sphere { <-.7, 1.3, 0>, .7 texture { T pigment { checker rgb y, rgb 1 } } }
sphere { <.7, 1.3, 0>, .7 texture { T } pigment { cells } }
sphere { <2.2, 1.3, 0>, .7 pigment { checker rgb 1, rgb 0 scale .2 } pigment { square } }
