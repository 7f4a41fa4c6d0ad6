// Light that is projected through an object, from behind what would cast a shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,2,-8> look_at <0,0.5,0> angle 50 }
light_source { <0,6,-2> rgb 1 projected_through { difference { box { <-2,3,-3>, <2,3.2,2> } cylinder { <0,2,0>, <0,4,0>, 0.6 } } } }
light_source { <-20,20,-30> rgb 0.2 }
plane { y, 0 pigment { rgb 0.9 } }
sphere { <0,0.6,0>, 0.6 pigment { rgb <1,0.5,0.4> } finish { phong 0.4 } }
sphere { <0.4,4.5,-1>, 0.4 pigment { rgb 0.5 } }
