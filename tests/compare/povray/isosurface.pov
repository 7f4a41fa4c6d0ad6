// The scene with settings of POV-Ray's that it needs to come to the same picture (../README.md).
// Isosurfaces: one with caps, an open one, one in a sphere, one cut, one of glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <1,5,-9> look_at <0,.2,0> angle 42 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } finish { reflection .2 } }
#declare F = function(x,y,z,r) { sqrt(x*x+y*y+z*z) - r + .08*sin(12*x)*sin(12*y)*sin(12*z) }
isosurface { function { F(x,y,z,.8) } max_gradient 12 accuracy 1e-6 translate <-3,0,0> pigment { rgb <1,.6,.2> } finish { phong 1 } }
isosurface { function { abs(x)-.2+sin(3*y)*.3*z } contained_by { box { -.9, .9 } } max_gradient 12 accuracy 1e-6 translate <-.9,0,1> pigment { rgb <.3,.8,.3> } }
isosurface { function { y*y+x*x-.4*(z+1) } open contained_by { sphere { 0, 1 } } max_gradient 12 accuracy 1e-6 translate <1.2,0,.5> pigment { rgb <.4,.5,1> } }
difference { isosurface { function { x*x*x*x+y*y*y*y+z*z*z*z-.4 } max_gradient 12 accuracy 1e-6 } box { 0, <2,2,-2> } translate <3.2,-.2,0> pigment { rgb <.9,.3,.5> } }
isosurface { function { F(x,y*.7,z,.6) } max_gradient 12 accuracy 1e-6 translate <.4,0,-2> pigment { rgbf <.8,1,.9,.9> } interior { ior 1.3 } }
