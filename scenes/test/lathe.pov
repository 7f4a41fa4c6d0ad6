// Lathes and surfaces of revolution: every spline, one cut open, one of glass, an open one.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <1,5,-9> look_at <0,.4,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } finish { reflection .2 } }
lathe { linear_spline 5, <0,-1>, <.8,-1>, <.3,0>, <.7,.6>, <0,1.2> translate <-3,0,0> pigment { rgb <1,.6,.2> } finish { phong 1 } }
lathe { quadratic_spline 5, <0,-1.4>, <0,-1>, <1,-.5>, <.4,.4>, <0,1> rotate 20*z translate <-1,0,1> pigment { rgb <.3,.8,.3> } finish { phong 1 } }
difference { lathe { cubic_spline 7, <0,-1.4>, <0,-1>, <.96,-.5>, <.45,.1>, <.8,.7>, <0,1.2>, <0,1.5> } box { 0, <2,2,-2> } translate <1,0,0> pigment { rgb <.4,.5,1> } }
lathe { bezier_spline 8, <.6,-.3>, <1,-.3>, <1,.3>, <.6,.3>, <.6,.3>, <.2,.3>, <.2,-.3>, <.6,-.3> rotate 60*x translate <3,0,0> pigment { rgb <.9,.3,.5> } }
sor { 6, <.4,-1.4>, <.6,-1>, <.8,-.4>, <.4,.3>, <.7,.9>, <.6,1.3> open scale .8 translate <-1.6,-.2,-2> pigment { rgb <.9,.9,.3> } }
sor { 5, <0,-1.1>, <.5,-1>, <.6,-.4>, <.2,.3>, <.4,.9> translate <.5,0,-2.6> pigment { rgbf <.8,1,.9,.9> } interior { ior 1.4 } }
superellipsoid { <.25,.5> scale .6 rotate <20,30,0> translate <2.4,-.4,-2.2> pigment { rgb <.5,.9,.9> } finish { phong 1 } }
superellipsoid { <.05,.05> scale .3 translate <-3.2,-.7,-2.2> pigment { rgb <.9,.7,.9> } }
superellipsoid { <2.5,1> scale .5 rotate 40*y translate <-.6,1.6,-1> pigment { rgb <.9,.5,.2> } }
