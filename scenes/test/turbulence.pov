// Turbulence before and behind transformations, with all of its words.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, .6, 0> angle 42 }
light_source { <6, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
plane { y, -1 pigment { checker rgb .9, rgb <.3, .4, .6> turbulence .2 scale 1.5 } }
sphere { 0, 1 pigment { bozo turbulence .6 scale .4 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, -1> }
sphere { 0, 1 pigment { bozo scale .4 turbulence .6 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, -1> }
sphere { 0, 1 pigment { gradient y turbulence <.2, .5, .9> octaves 4 lambda 2.3 omega .6 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, -1> }
sphere { 0, 1 pigment { gradient x turbulence .5 octaves 1 scale .5 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <-2.3, .1, 1.2> }
sphere { 0, 1 pigment { onion turbulence .7 omega .8 scale .6 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <0, .1, 1.2> }
sphere { 0, 1 pigment { gradient x turbulence .5 lambda 3.5 rotate z*40 scale .4 color_map { [0 rgb <1, .9, .6>] [.5 rgb <.7, .2, .1>] [1 rgb <.1, .1, .5>] } } translate <2.3, .1, 1.2> }
