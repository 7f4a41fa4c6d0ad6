// Columns in the low light of two wide lamps: shadows that begin sharp and end soft.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <-3.5, 3.2, -8> look_at <.4, .9, 1> angle 42 }
light_source { <9, 5, -4> rgb <1, .92, .8> area_light 3*y, 3*z, 6, 6 circular orient jitter }
light_source { <-7, 8, -2> rgb <.18, .24, .36> area_light 4*x, 4*z, 5, 5 jitter }
background { rgb <.4, .5, .65> }
plane { y, 0 pigment { rgb <.7, .66, .58> } finish { ambient .06 } }
#for (I, 0, 4)
    #for (K, 0, 1)
        union {
            box { <-.4, 0, -.4>, <.4, .18, .4> } cylinder { .18*y, 2.1*y, .26 } torus { .27, .05 translate .2*y }
            torus { .25, .05 translate 2.08*y } box { <-.4, 2.12, -.4>, <.4, 2.3, .4> }
            translate <I*1.3 - 2, 0, K*2.6> pigment { rgb <.8, .77, .7> } finish { ambient .06 specular .1 }
        }
    #end
#end
box { <-2.6, 2.3, -.4>, <3.8, 2.55, .4> pigment { rgb <.75, .7, .62> } finish { ambient .06 } }
sphere { <.4, .5, -1.4>, .5 pigment { rgb <.7, .3, .2> } finish { ambient .06 phong .5 reflection .08 } }
