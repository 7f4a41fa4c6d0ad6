// A mesh of flat and smooth faces; one as a solid that a ball is taken from, moved twice; a transparent one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-9> look_at <0,.4,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1.2 pigment { rgb <.5,.6,.7> } }
#declare Octahedron = mesh {
    triangle { x, y, z } triangle { y, -x, z } triangle { -x, -y, z } triangle { -y, x, z }
    triangle { y, x, -z } triangle { -x, y, -z } triangle { -y, -x, -z } triangle { x, -y, -z }
    inside_vector <.3,.9,.1>
}
difference {
    object { Octahedron rotate y*20 }
    sphere { <0,.4,-.6>, .5 pigment { rgb <1,.6,.2> } }
    translate <-2.6,0,0> pigment { rgb <.3,.8,.3> }
}
intersection { object { Octahedron rotate x*30 scale <1,1.3,1> } box { -.7, .7 } translate <-.4,.2,0> pigment { rgb <.9,.3,.5> } }
mesh {
    #local I = 0;
    #while (I < 6)
        #local A = vrotate(x, y*60*I); #local B = vrotate(x, y*60*(I+1));
        smooth_triangle { A, A+y*.3, B, B+y*.3, y, y }
        triangle { A, B, -y*.8 }
        #local I = I + 1;
    #end
    hierarchy off
    rotate <20,10,0> translate <1.8,.2,0> pigment { rgb <.6,.7,.9> } finish { phong .8 phong_size 30 }
}
object { Octahedron scale .8 translate <3.4,0,.5> pigment { rgbt <.8,1,.9,.7> } }
