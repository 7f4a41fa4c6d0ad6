// Area lights: weights of odd counts, circular, area_illumination, moved with their axes; a lamp that looks like one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -8> look_at <0, 0, 0> angle 50 }
light_source { <0, 0, 0> rgb .6 area_light 2*x, 2*z, 5, 3 rotate 20*z translate <-3, 5, -1> }
light_source { <3, 5, -2> rgb <.5, .4, .3> area_light 2*x, 2*y, 4, 4 circular area_illumination on adaptive 1 }
light_source { <0, 2.5, 1> rgb .2 looks_like { sphere { 0, .2 pigment { rgb 1 } finish { emission 1 } } } fade_distance 2 fade_power 2 }
plane { y, 0 pigment { rgb .9 } finish { ambient 0 } }
sphere { <-1.5, .7, 0>, .7 pigment { rgb <.8, .5, .4> } finish { phong .6 ambient .05 } }
box { <.6, 0, -.5>, <1.4, 1.6, .5> pigment { rgb <.5, .6, .8> } finish { ambient .05 } }
