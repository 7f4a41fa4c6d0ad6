// Triangles, one of them a sliver; a pyramid of shared edges, smooth ones with a highlight, one in a solid.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,3,-8> look_at <0,.4,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1 pigment { rgb <.5,.6,.7> } }
#declare A = <-1,-.8,-1>; #declare B = <1,-.8,-1>; #declare C = <1,-.8,1>; #declare D = <-1,-.8,1>; #declare T = <0,.6,0>;
union {
    triangle { A, B, T } triangle { B, C, T } triangle { C, D, T } triangle { D, A, T }
    rotate y*25 translate <-2,0,0> pigment { rgb <1,.6,.2> } finish { phong 1 }
}
triangle { <0,-.9,-2>, <3,-.8,-2>, <1,-.895,-2> pigment { rgb <.3,.8,.3> } }
smooth_triangle { <.2,-.6,0>, <-1,-1,-1>, <2.6,-.6,.3>, <1,-.5,-1>, <1.2,2,.2>, <0,.8,-1>
    pigment { rgb <.6,.7,.9> } finish { phong .8 phong_size 20 } }
intersection {
    sphere { <0,1.6,0>, .6 } triangle { <-2,1.2,0>, <2,1.3,-.4>, <0,3,.2> pigment { rgb <.9,.3,.5> } }
    pigment { rgb <1,1,.4> }
}
