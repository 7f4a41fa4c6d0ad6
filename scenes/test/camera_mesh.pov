// Rays from the faces of a mesh, found by their uv coordinates.
#version 3.7;
global_settings { assumed_gamma 1 }
camera {
    mesh_camera {
        1 3
        mesh {
            triangle { <-2, -1.5, 0>, <-2, 1.5, 0>, <2, 1.5, 0> uv_vectors <0, 0>, <0, 1>, <1, 1> }
            triangle { <-2, -1.5, 0>, <2, 1.5, 0>, <2, -1.5, 1> uv_vectors <0, 0>, <1, 1>, <1, 0> }
            rotate 10*y
            translate <0, 1.2, -4>
        }
    }
    location <0, 0, -.01>
}
light_source { <-6, 9, -8> rgb 1 }
sphere { <0, 1, 0>, 1 pigment { rgb <.9, .6, .3> } finish { ambient .1 diffuse .7 phong .4 } }
box { <-2.2, 0, -.4>, <-1.4, 1.4, .4> pigment { rgb <.3, .5, .8> } }
plane { y, 0 pigment { checker rgb .8, rgb <.3, .5, .3> } }
plane { -z, -20 pigment { rgb <.5, .6, .9> } }
