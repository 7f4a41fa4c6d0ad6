// Sweeps of spheres, heights, patches and an ovus; a sweep of glass, a height field that cuts a box.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <1,5,-9> look_at <0,.2,0> angle 42 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } finish { reflection .2 } }
sphere_sweep { linear_spline 3, <-1,0,0>, .3, <0,1,0>, .15, <1,-.2,.3>, .4 translate <-2.8,0,0> pigment { rgb <1,.6,.2> } finish { phong 1 } }
sphere_sweep { b_spline 6, <-1,-1,0>, .3, <-.8,0,0>, .2, <0,1,.4>, .3, <.6,-.6,0>, .2, <1,.8,0>, .25, <1.4,1,0>, .3 translate <-.6,.2,1> pigment { rgb <.3,.8,.3> } finish { phong 1 } }
sphere_sweep { cubic_spline 5, <-1,0,0>, .2, <-.6,0,0>, .2, <0,.6,0>, .3, <.6,0,.3>, .2, <1,0,0>, .2 translate <1,-.5,-2.6> pigment { rgbf <.8,1,.9,.9> } interior { ior 1.3 } }
height_field { function 40, 40 { .5 + .3*sin(11*x)*cos(8*y) } smooth scale <2,1,2> translate <1.6,-.9,-.6> pigment { rgb <.4,.5,1> } }
intersection { height_field { function 20, 20 { .4 + .3*sin(9*x)*cos(7*y) } water_level .2 } box { <.1,0,.1>, <.9,1,.9> } scale <1.6,1,1.6> translate <-2.8,-1,-3.2> pigment { rgb <.9,.3,.5> } }
bicubic_patch { type 1 u_steps 4 v_steps 4 <0,0,0>, <.5,.8,0>, <1,-.4,0>, <1.5,0,0>, <0,.3,.5>, <.5,0,.5>, <1,.4,.5>, <1.5,0,.5>, <0,0,1>, <.5,.2,1>, <1,0,1>, <1.5,.4,1>, <0,.3,1.5>, <.5,0,1.5>, <1,.3,1.5>, <1.5,0,1.5> translate <1,.6,1.4> pigment { rgb <.9,.9,.3> } finish { phong 1 } }
ovus { .5, .3 translate <-.4,-.5,-2> pigment { rgb <.5,.9,.9> } finish { phong 1 } }
