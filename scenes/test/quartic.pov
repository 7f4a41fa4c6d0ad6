// Polynomials: a quartic, a cubic, one of order 6, one by its terms, cut to size; a quartic of glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <1,5,-9> look_at <0,.2,0> angle 42 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } finish { reflection .2 } }
#declare T = quartic { <1,0,0,0,2,0,0,2,0,-2.32,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,1.68,0,0,0,0,1,0,-2.32,0,.7056> sturm }
object { T rotate 70*x translate <-2.8,.3,0> pigment { rgb <1,.6,.2> } finish { phong 1 } }
object { T scale .7 rotate -50*x translate <1.2,0,-2.4> pigment { rgbf <.8,1,.9,.9> } interior { ior 1.3 } }
intersection { cubic { <1,0,0,0,0,0,0,0,0,-.6,0,0,0,0,0,0,0,-1,0,.1> } sphere { 0, 1 } translate <.3,.1,1> pigment { rgb <.3,.8,.3> } }
intersection { poly { 6, <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0,0,-.4> } box { -.95, .95 } translate <2.8,0,0> pigment { rgb <.4,.5,1> } }
intersection { polynomial { 4, xyz(4,0,0): 1, xyz(0,4,0): 1, xyz(0,0,4): 1, xyz(2,0,0): -1 xyz(0,2,0): -1 xyz(0,0,2): -1 xyz(0,0,0): .4 } sphere { 0, 1.2 } scale .7 translate <-1.4,-.1,-2.4> pigment { rgb <.9,.3,.5> } }
