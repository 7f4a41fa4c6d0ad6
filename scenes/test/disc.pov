// Discs: a plate, a ring, one aslant; and one as the half-space that cuts a sphere, of which only the ring is seen.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-8> look_at <0,.4,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } }
disc { <-2,0,0>, <0,1,-1>, 1 pigment { rgb <1,.6,.2> } finish { phong 1 } }
disc { <0,0,0>, <1,2,-3>, 1.2, .5 pigment { rgb <.3,.8,.3> } finish { reflection .3 } }
intersection { sphere { <2.4,0,0>, 1.1 } disc { <2.4,.3,0>, <0,1,-.5>, 3, .3 pigment { rgb <.9,.3,.5> } } pigment { rgb <1,1,.4> } }
disc { 0, x+y, .5 scale <1,2,1> rotate y*30 translate <1,1.2,-1> pigment { rgbf <.8,.9,1,.8> } }
