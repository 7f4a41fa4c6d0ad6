// Spotlights: a soft edge, a hard one, tightness; a cylinder; parallel light; fading.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> look_at <0, 0, 0> angle 50 }
light_source { <-4, 4, 0> rgb <1, .3, .2> spotlight point_at <-3, 0, 0> radius 12 falloff 20 }
light_source { <0, 5, 1> rgb <.2, 1, .3> spotlight point_at <0, 0, 1> radius 18 falloff 18 tightness 4 }
light_source { <3, 4, 0> rgb <.3, .4, 1> cylinder point_at <3, 0, .5> radius .5 falloff 1 tightness .5 }
light_source { <6, 6, -6> rgb .25 parallel point_at <0, 0, 0> }
light_source { <0, 2, -3> rgb .8 fade_distance 1.5 fade_power 2 shadowless }
plane { y, 0 pigment { rgb .9 } finish { ambient 0 } }
sphere { <-3, .5, 0>, .5 pigment { rgb 1 } finish { phong .5 ambient 0 } }
box { <-.4, 0, .6>, <.4, .8, 1.4> pigment { rgb 1 } finish { ambient 0 } }
sphere { <3, .4, .5>, .4 pigment { rgb 1 } finish { phong .5 ambient 0 } }
