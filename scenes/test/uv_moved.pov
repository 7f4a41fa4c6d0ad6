// What moves uv coordinates and what does not; bumps that turn with the object or stay; bumps of a texture's members.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <-4, 8, -9> rgb 1 }
box { -.7, .7 texture { pigment { uv_mapping checker rgb <.9, .8, .3>, rgb <.2, .4, .7> scale .08 }
    normal { uv_mapping crackle .6 scale .1 } scale 3 rotate z*30 } rotate <30, 40, 20> translate <-2, 1, 0> }
box { -.7, .7 texture { uv_mapping pigment { checker rgb <.9, .8, .3>, rgb <.2, .4, .7> scale .08 }
    normal { crackle .6 scale .1 } scale 2 } rotate <30, 40, 20> translate <0, 1, 0> }
box { -.7, .7 uv_mapping texture { pigment { checker rgb <.9, .8, .3>, rgb <.2, .4, .7> scale .08 }
    normal { crackle .6 scale .1 } scale 2 } rotate <30, 40, 20> translate <2, 1, 0> }
box { -.7, .7 uv_mapping texture { bozo texture_map { [0 pigment { checker rgb <.9, .8, .3>, rgb <.2, .4, .7> scale .08 } normal { crackle .6 scale .1 }] 
    [1 pigment { rgb 1 } normal { crackle .6 scale .1 }] } scale .2 }
    rotate <30, 40, 20> translate <-2, -1, 0> }
sphere { <0, -1, 0>, .8 texture { bozo texture_map { [0 pigment { rgb .9 } normal { bumps .3 scale .5 no_bump_scale }] [1 pigment { rgb .6 } normal { dents }] }
    scale <.2, .3, .1> } }
sphere { <2, -1, 0>, .8 texture { average texture_map { [1 pigment { rgb <1, .7, .4> } normal { ripples .4 scale .4 no_bump_scale }] } scale .3 } }
