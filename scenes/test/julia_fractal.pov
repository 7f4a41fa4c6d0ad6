// Julia sets of quaternions and hypercomplex numbers, one cut open, one in another slice.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,3,-7> look_at <0,0,0> angle 42 }
light_source { <-10,20,-10> rgb 1 }
plane { y, -1.5 pigment { rgb <.5,.6,.7> } }
julia_fractal { <-.167,-.083,-.676,-.098> quaternion sqr max_iteration 6 precision 100 translate -1.6*x pigment { rgb <1,.6,.2> } finish { phong .6 } }
difference { julia_fractal { <-.3,.2,.4,.1> quaternion cube max_iteration 5 precision 60 slice <0,.2,0,1>, .1 } box { 0, <2,2,-2> } translate 1.6*x pigment { rgb <.3,.7,1> } }
julia_fractal { <-.5,.3,-.2,0> hypercomplex sqr max_iteration 6 precision 80 scale .6 translate <0,-.8,-1.6> pigment { rgb <.5,.9,.5> } }
