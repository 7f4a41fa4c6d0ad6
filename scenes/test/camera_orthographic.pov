// Parallel rays: the picture is as wide as a perspective one is where the camera looks.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3,4,-8> direction 2*z look_at <0,0.5,0> scale 1.5 rotate y*10 }
light_source { <5,10,-6> rgb 1 }
background { rgb <.3,.5,.8> }
box { <-40,-2,-40>, <40,-1,40> pigment { checker rgb .9, rgb .6 } }
sphere { 0, 1.2 pigment { checker rgb <.9, .2, .1> scale .4 } }
box { <1.2,-.9,-1>, <2,1,1> pigment { rgbf <.9,.5,.5,.8> } interior { ior 1.3 } }
