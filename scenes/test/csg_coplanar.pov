// Solids that stand on a floor, and clipped planes that lie in one plane: rays start in the planes of what they do not meet.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -14> look_at <0, 1.5, 0> angle 50 }
light_source { <30, 40, -25> rgb .7 }
light_source { <-40, 6, -20> rgb .5 }
plane { y, 0 pigment { rgb .8 } }
#declare Sheet = plane { z, 0 clipped_by { box { -1, 1 } } pigment { rgb <.9, .4, .3> } }
object { Sheet translate <-3, 3.5, 0> }
object { Sheet translate <-.5, 3.5, 0> }
object { Sheet translate <2, 3.5, 0> }
difference { box { <-4, 0, -2> <-2, 2, 0> } sphere { <-3, 1, -2>, .8 } pigment { rgb <.4, .7, .9> } }
difference { box { <-1, 0, -2> <1, 2, 0> } cylinder { <0, 0, -2> <0, 3, -2>, .6 } box { <-.2, 0, -3> <.2, .5, 1> } pigment { rgb <.6, .9, .4> } }
intersection { box { <2, 0, -2> <4, 2, 0> } sphere { <3, 0, -1>, 1.3 } plane { -x, -2 } pigment { rgbt <.9, .8, .3, .4> } }
