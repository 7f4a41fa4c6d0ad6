// Tori: a ring, one of glass that is turned and stretched, one with a corner cut out, a spindle.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <3,4,-8> look_at <0,.5,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } finish { reflection .2 } }
torus { 2, .6 pigment { rgb <1,.6,.2> } finish { phong 1 reflection .2 } }
torus { 1, .3 rotate x*70 rotate y*20 translate <0,1.4,0> scale <1,1.4,1> pigment { rgbf <.8,1,.85,.9> } interior { ior 1.5 } finish { phong .8 } }
difference { torus { .8,.4 } box { 0, 2 } translate <-3,0,-2> pigment { rgb <.3,.8,.3> } }
torus { .3,.6 translate <3,0,-2> pigment { rgb <.9,.3,.5> } }
