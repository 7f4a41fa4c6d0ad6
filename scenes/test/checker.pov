// Checkers on faces at whole coordinates, on a turned sphere, and on glass, whose shadow is checkered too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 6, -9> look_at <0, .5, 0> }
light_source { <6, 10, -3> rgb 1 }
background { rgb <.3, .5, .8> }
box { <-40, -2, -40>, <40, -1, 40> pigment { checker rgb .9, rgb .6 } }
sphere { 0, 1.2 pigment { checker rgb <.9, .2, .1> scale .4 } finish { phong .5 } rotate <20, 40, 60> translate <-3, .8, 1> }
box { <-4, -1, -3>, <-2, 1, -2> pigment { checker } }
#declare Panes = pigment { checker rgbf <1, .2, .1, .9>, rgbft <.2, .3, 1, .5, .4> scale .5 translate .1 };
box { -1, 1 pigment { Panes } rotate y*25 translate <-.3, .1, -.5> }
cone { <3, -.9, 0>, 1.2, <2.6, 1.8, .2>, .3 pigment { Panes } }
difference { sphere { <0, 0, 0>, 1.1 } box { <-2, .3, -2>, <2, 2, 2> } pigment { Panes } finish { reflection .1 } translate <0, .3, 3.2> }
