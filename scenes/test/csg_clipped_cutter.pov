// Cutters that are clipped: what is left is clipped by the same. And the same by inverse members.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb .2 }
camera { location <1, 3, -8> look_at 0 angle 32 }
light_source { <1, 9, -9> rgb 1 }
#declare Warm = texture { pigment { rgb <.9, .4, .3> } finish { ambient .3 diffuse .5 } }
#declare Cold = texture { pigment { rgb <.3, .4, .9> } finish { ambient .3 diffuse .5 } }
#declare Cutter = sphere { <.4, .5, -.9>, .8 texture { Cold } clipped_by { plane { x, .3 } } }
difference { sphere { 0, 1 texture { Warm } } object { Cutter } translate -1.4*x }
intersection { sphere { 0, 1 texture { Warm } } object { Cutter inverse } translate <1.4, .6, 0> }
difference {
    sphere { 0, 1 texture { Warm } }
    union { sphere { <.4, .5, -.9>, .8 texture { Cold } } box { -.3, .3 texture { Cold } } clipped_by { plane { x + y, .4 } } }
    translate <.8, -1.2, 0>
}
