// A rainbow before the background and a wall, faded at its ends; fog over it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, 0> look_at <0, 6, 20> angle 80 }
light_source { <0, 30, -50> rgb 1 }
background { rgb <.4, .5, .7> }
rainbow {
  direction <0, 0, 1> angle 30 width 8 distance 15 arc_angle 200 falloff_angle 100
  color_map { [0 rgbt <.5, .1, .8, .9>] [.3 rgbt <.1, .3, 1, .3>] [.6 rgbt <.2, .9, .2, .2>] [1 rgbt <1, .1, .1, .9>] }
}
fog { distance 60 rgb .7 }
plane { y, 0 pigment { rgb <.3, .5, .2> } }
box { <-9, 0, 18>, <-5, 8, 20> pigment { rgb <.8, .7, .5> } }
