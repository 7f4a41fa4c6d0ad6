// Blobs: spheres, a cylinder, a hole, moved components, textures of components, glass, a cut.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <1,5,-9> look_at <0,.2,0> angle 42 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } finish { reflection .2 } }
blob { threshold .6 sphere { <-.5,0,0>, 1.2, 1 } sphere { <.5,.2,0>, 1, 1 } sphere { <0,.5,-.4>, .6, -.8 } translate <-2.8,0,0> pigment { rgb <1,.6,.2> } finish { phong 1 } }
blob { threshold .3 cylinder { <-1,0,0>, <1,.6,0>, .6, 1 } sphere { 0, 1, 1 scale <.5,1.4,.5> rotate 30*z } translate <.2,0,1> pigment { rgb <.3,.8,.3> } }
blob { threshold .4 sphere { <-.4,0,0>, 1, 1 pigment { rgb <1,.2,.2> } } sphere { <.5,0,0>, 1, 1 texture { pigment { rgb <.2,.3,1> } finish { phong 1 } } } translate <2.8,0,0> }
difference { blob { threshold .5 sphere { <-.4,0,0>, 1, 1 } sphere { <.4,0,0>, 1, 1 } } box { <0,0,-2>, 2 } translate <-1.6,-.2,-2.4> pigment { rgb <.9,.3,.5> } }
blob { threshold .5 sphere { <-.3,0,0>, 1, 1 } sphere { <.5,.2,0>, .8, 1 } translate <1,-.2,-2.4> pigment { rgbf <.8,1,.9,.9> } interior { ior 1.3 } }
