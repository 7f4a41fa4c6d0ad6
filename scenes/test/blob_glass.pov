// Solids within a blob of glass: rays that start on them leave it where it ends.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
background { rgb <.1, .15, .3> }
camera { location <1, 2, -5> look_at 0 right x*4/3 angle 28 }
light_source { <3, 6, -6> rgb 1 }
plane { y, -1.2 pigment { gradient x color_map { [0 rgb .3] [.5 rgb .9] [1 rgb .3] } scale 3 } finish { ambient .2 diffuse .6 } }
blob {
    threshold .5
    sphere { -.4*x, 1, 1 }
    cylinder { -.2*y, <.7, .4, 0>, .8, 1 }
    pigment { rgbf <.9, .6, .9, .8> }
    finish { ambient .1 diffuse .2 }
}
sphere { <-.4, .1, 0>, .3 pigment { rgbf <.9, .9, .4, .7> } finish { ambient .2 diffuse .3 } }
cone { <.2, -.6, 0>, .3, <.6, .9, .1>, .1 pigment { rgbt <.5, .8, 1, .6> } finish { ambient .2 diffuse .3 } }
