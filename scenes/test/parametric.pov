// Parametric surfaces: a shell in a container, a ruled strip.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1,4,-7> look_at <0,0,0> angle 42 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1.5 pigment { rgb <.5,.6,.7> } }
parametric { function { u*cos(v) } function { .332*v-1 } function { u*sin(v) } <.1,0>, <1.3,6.28> contained_by { box { <-1.4,-1.1,-1.4>, <1.4,1.6,1.4> } } accuracy .0005 max_gradient 3 translate -1.5*x pigment { rgb <1,.6,.2> } finish { phong .6 } }
parametric { function { (1+.4*cos(v))*cos(u) } function { .4*sin(v) } function { (1+.4*cos(v))*sin(u) } <0,0>, <6.2831853,6.2831853> contained_by { box { <-1.5,-1,-1.5>, <1.5,.2,1.5> } } rotate -30*x translate 1.6*x pigment { rgb <.3,.7,1> } }
