// A pattern on members of a difference and of an intersection, which take them along; its shadow through glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,5,-7> look_at <0,0.5,0> }
light_source { <5,10,-6> rgb 1 }
background { rgb <.3,.5,.8> }
box { <-40,-2,-40>, <40,-1,40> pigment { rgb 1 } }
difference { box { -1, 1 } sphere { <0,1,-1>, .8 pigment { square scale .22 } } pigment { square rgbf <1,0,0,.9>, rgbt <0,0,0,.8>, rgbft <.2,.9,.2,.5,.4> rgb <1,1,0> scale .4 translate .13 } rotate y*30 translate <-1.5,.3,0> }
intersection { sphere { <-.5,0,0>, 1.2 } sphere { <.5,0,0>, 1.2 texture { pigment { square rgbt <1,0,0,.9> rgbt <1,1,1,.5> scale .3 } } } texture { pigment { square rgbt .7 rgbf <0,1,0,.7> scale .3 rotate x*40 } finish { phong .5 } } rotate <0,20,40> translate <1.8,.8,0> }
