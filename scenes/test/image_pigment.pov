// Images that pigments make: colours and transparency, heights of bumps, values of a map.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
plane { z, 2 pigment { checker rgb .9 rgb .5 } }
#declare P = pigment { bozo color_map { [0 rgb <1, .2, .1>] [.5 rgb <.1, .8, .3>] [1 rgbt <.1, .2, .9, .5>] } scale .2 }
box { <-1, -1, 0>, <1, 1, .1> pigment { image_map { function 40, 30 { pigment { P } } } translate -.5 scale 2.02 } translate x*-2.2 }
box { <-1, -1, 0>, <1, 1, .1> pigment { image_pattern { function 40, 30 { pigment { P } } } color_map { [0 rgb <0, 0, .5>] [1 rgb <1, .8, .3>] } translate -.5 scale 2.02 } }
sphere { <2.3, 0, 0>, 1.1 pigment { rgb .9 } normal { bump_map { function 40, 30 { pigment { P } } map_type 1 interpolate 2 bump_size 2 } } }
