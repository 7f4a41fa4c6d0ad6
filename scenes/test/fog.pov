// Fog near the ground with a filter, thin fog everywhere; none in a glass ball that is not hollow; a mirror and a sky.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 2, -8> look_at <0, 1, 0> angle 50 }
light_source { <5, 8, -6> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <.9, .8, .7>] [.5 rgb <.2, .4, .9>] } } emission .8 }
fog { fog_type 2 distance 6 rgbft <.8, .8, .9, .2, .1> fog_offset .2 fog_alt .5 }
fog { distance 40 rgb <.5, .5, .6> }
plane { y, 0 pigment { rgb <.3, .5, .2> } }
sphere { <-2, 1, 0>, 1 pigment { rgbt <1, 1, 1, .9> } }
sphere { <.5, 1, 1>, 1 pigment { rgb .1 } finish { reflection .7 } }
box { <2, 0, 2>, <3, 2, 9> pigment { rgb <.9, .3, .2> } }
