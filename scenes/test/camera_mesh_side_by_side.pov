// Two meshes side by side: each half of the picture has a mesh with a face for each of its pixels.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare across = image_width/2;
#declare eye = mesh {
    #for (row, 0, image_height - 1)
        #for (column, 0, across - 1)
            triangle { <column, -row, 0>*4/image_height, <column, .9 - row, 0>*4/image_height, <column + .9, -row, 0>*4/image_height }
        #end
    #end
}
camera { mesh_camera { 1 2 mesh { eye translate <-1.5, 3.2, -4> } mesh { eye rotate -20*y translate <-3, 3.2, -4> } } }
light_source { <-6, 9, -8> rgb 1 }
sphere { <0, 1, 0>, 1 pigment { rgb <.9, .6, .3> } finish { ambient .1 diffuse .7 phong .4 } }
box { <-2.2, 0, -.4>, <-1.4, 1.4, .4> pigment { rgb <.3, .5, .8> } }
plane { y, 0 pigment { checker rgb .8, rgb <.3, .5, .3> } }
plane { -z, -20 pigment { rgb <.5, .6, .9> } }
