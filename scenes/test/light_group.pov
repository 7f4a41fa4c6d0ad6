// Lights that shine on the objects of their group, with and without those of the rest of the scene; shadows of all.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .3, 0> angle 45 }
light_source { <5, 8, -4> rgb .8 }
light_group {
  light_source { <-6, 6, -4> rgb <1, .4, .2> }
  sphere { <-2, .8, 0>, .8 pigment { rgb 1 } }
  union { box { <-1, 0, 0>, <-.4, 1, .6> } cone { <-.7, 1, .3>, .3, <-.7, 1.8, .3>, 0 } pigment { rgb 1 } }
  rotate 10*y
}
light_group {
  light_source { <-6, 6, -4> rgb <.2, .4, 1> }
  sphere { <.8, .8, 0>, .8 pigment { rgb 1 } finish { phong .7 } }
  global_lights on
}
sphere { <2.7, .6, 0>, .6 pigment { rgb <.4, .8, .4> } }
plane { y, 0 pigment { rgb .7 } }
