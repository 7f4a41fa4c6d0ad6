// Light falls through windows into a hall full of mist.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <-1.5, 1.8, -9> look_at <.6, 2.2, 2> angle 58 }
light_source { <14, 12, 3> rgb <1.9, 1.7, 1.3>*3 }
light_source { <0, 4, -8> rgb .3 shadowless media_interaction off }
difference {
    box { <-4.2, -.2, -10.2>, <4.2, 5.2, 10.2> }
    box { <-4, 0, -10>, <4, 5, 10> }
    #for (I, -2, 3)
        box { <3.5, 1.4, I*2.6 - .5>, <4.5, 4, I*2.6 + .5> }
        cylinder { <3.5, 4, I*2.6>, <4.5, 4, I*2.6>, .5 }
    #end
    pigment { rgb <.62, .56, .48> } finish { ambient .04 diffuse .75 }
}
#for (I, -2, 3)
    union {
        cylinder { 0, 5*y, .28 } cylinder { 0, .3*y, .42 } cylinder { 4.7*y, 5*y, .42 }
        translate <-2, 0, I*2.6 + 1.3> pigment { rgb <.7, .65, .58> } finish { ambient .04 }
    }
#end
box { <-3.99, .01, -9.99>, <3.99, 4.99, 9.99> hollow pigment { rgbt 1 }
    interior { media { scattering { 1, .03 extinction .5 } intervals 1 samples 12 } } }
