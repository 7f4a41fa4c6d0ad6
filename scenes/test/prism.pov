// Prisms: every spline, a cone, an open one, a ring with a hole, one cut out of a box, glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <2,6,-9> look_at <0,.2,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } finish { reflection .2 } }
prism { 0, .5, 9, <-1,-1>, <1,-1>, <1,1>, <-1,1>, <-1,-1>, <-.5,-.5>, <.5,-.5>, <0,.5>, <-.5,-.5> rotate -70*x translate <-3,0,1> pigment { rgb <1,.6,.2> } }
prism { quadratic_spline -1, 0, 6, <-1,0>, <1,-1>, <1,1>, <-1,1>, <-1,-1>, <1,-1> scale <.7,1,.7> pigment { rgb <.3,.8,.3> } finish { phong 1 } }
prism { cubic_spline 0, 1, 8, <-1,-1>, <1,-1>, <.3,.2>, <1,1>, <-1,1>, <1,-1>, <.3,.2>, <1,1> translate <2.6,-1,0> pigment { rgb <.4,.5,1> } }
prism { bezier_spline -1, .3, 8, <0,0>, <2,0>, <1,1>, <0,1>, <0,1>, <-1,1>, <-2,0>, <0,0> open translate <-.5,0,2> pigment { rgb <.9,.3,.5> } }
prism { conic_sweep linear_spline 0, 1, 5, <1,1>, <-1,1>, <-1,-1>, <1,-1>, <1,1> rotate 180*x scale <.8,1.4,.8> translate <-2.6,.4,-2> pigment { rgb <.9,.9,.3> } }
difference { box { <-1,-1,-1>, <1,0,1> } prism { bezier_spline -2, 2, 8, <0,-.7>, <1,-.7>, <1,.7>, <0,.7>, <0,.7>, <-1,.7>, <-1,-.7>, <0,-.7> } scale .8 translate <.4,-.2,-3> pigment { rgb .8 } }
prism { 0, 1, 6, <1,0>, <.3,.95>, <-.8,.59>, <-.8,-.59>, <.3,-.95>, <1,0> scale <.6,1.4,.6> translate <2.8,-.99,-2.4> pigment { rgbf <.8,1,.9,.9> } interior { ior 1.4 } }
