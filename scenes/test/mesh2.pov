// The same corners flat and smooth, with normals by face; inside a transformation, as a solid, and many times over.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-9> look_at <0,.4,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1.2 pigment { rgb <.5,.6,.7> } }
#declare Flat = mesh2 {
    vertex_vectors { 6, x, -x, y, -y, z, -z }
    face_indices { 8, <0,2,4>, <1,2,4>, <1,3,4>, <0,3,4>, <0,2,5>, <1,2,5>, <1,3,5>, <0,3,5> }
    inside_vector y
}
#declare Smooth = mesh2 {
    vertex_vectors { 6, x, -x, y, -y, z, -z }
    normal_vectors { 6, x, -x, y, -y, z, -z }
    face_indices { 8, <0,2,4>, <1,2,4>, <1,3,4>, <0,3,4>, <0,2,5>, <1,2,5>, <1,3,5>, <0,3,5> }
}
#declare Tilted = mesh2 {
    vertex_vectors { 4, <-1,0,-1>, <1,0,-1>, <1,0,1>, <-1,0,1> }
    normal_vectors { 2, <-.5,1,0>, <.5,1,0> }
    face_indices { 2, <0,1,2>, <0,2,3> }
    normal_indices { 2, <0,1,1>, <0,1,0> }
}
object { Flat rotate y*25 translate -2.7*x pigment { rgb <1,.6,.2> } }
object { Smooth rotate y*25 translate -.7*x pigment { rgb <.3,.8,.3> } finish { phong .7 } }
object { Tilted rotate x*-30 translate <1.4,.2,0> pigment { rgb <.9,.3,.5> } finish { phong .7 } }
difference { object { Flat rotate y*40 } box { <0,0,-2>, 2 pigment { rgb <1,1,.4> } } translate 3.2*x pigment { rgb <.6,.7,.9> } }
#declare I = 0;
#while (I < 20)
    object { Flat scale .15 rotate y*I*7 translate <I*.3-3,-1,-2> pigment { rgb <I/20,.5,1-I/20> } }
    #declare I = I + 1;
#end
