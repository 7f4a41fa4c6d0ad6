// Surface coordinates: of a mesh with them, of faces with textures of their own, of sphere, box and torus; and of a
// cylinder, which has none but x and y of the world.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0,3,-7> look_at <0,.3,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
mesh2 {
    vertex_vectors { 4, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0> }
    uv_vectors { 4, <0,0>, <1,0>, <1,1>, <0,1> }
    face_indices { 2, <0,1,2>, <0,2,3> }
    uv_mapping pigment { checker rgb 1 rgb <1,0,0> scale .25 } finish { ambient .5 }
    rotate y*30 translate -1.5*x
}
#declare T1=texture { uv_mapping pigment { checker rgb 1 rgb z scale .2 } }
#declare T2=texture { pigment { rgb y } finish { ambient .4 } }
mesh { triangle { <-1,-1,0>, <1,-1,0>, <1,1,0> uv_vectors <0,0>,<1,0>,<1,1> texture { T1 } }
 triangle { <-1,-1,0>, <1,1,0>, <-1,1,0> uv_vectors <0,0>,<1,1>,<0,1> texture { T2 } }
 rotate y*-30 translate 1.5*x texture { pigment { rgb x } } }
sphere { 0, .7 pigment { uv_mapping checker rgb 1 rgb 0 scale .1 } translate <0,1.6,0> rotate z*20}
box { -.5, <.5,.4,.3> pigment { uv_mapping checker rgb 1 rgb 0 scale .05 } scale 1.2 translate <2,1.6,0> }
torus { .6,.2 pigment { uv_mapping checker rgb 1 rgb 0 scale .1 } rotate x*-50 translate <-2,1.8,0> }
cylinder { 0, y, .3 pigment { uv_mapping checker rgb 1 rgb 0 scale .1 } translate <0,-.5,-2> }
