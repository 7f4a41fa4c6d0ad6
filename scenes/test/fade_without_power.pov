// A fade_distance alone: what is seen through the box is halved, its shadow is not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-9> look_at <0,0.4,0> angle 40 }
light_source { <3,8,-2> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.5 } }
box { <-2.4,0.2,-0.8>, <-0.8,1.6,0.8> pigment { rgbt <1,1,1,1> } finish { ambient 0 diffuse 0 } interior { fade_distance 1 } }
box { <0.8,0.2,-0.8>, <2.4,1.6,0.8> pigment { rgbt <1,1,1,1> } finish { ambient 0 diffuse 0 } interior { fade_distance 1 fade_power 1 } }
