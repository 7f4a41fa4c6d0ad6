// Letters cut into a plate and letters that stand on it.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <0, 3.4, -7.5> look_at <.25, .7, 0> angle 46 }
light_source { <-6, 8, -6> rgb 1 area_light 2*x, 2*y, 3, 3 jitter }
light_source { <7, 4, -5> rgb .25 shadowless }
background { rgb <.85, .87, .9> }
plane { y, -.3 pigment { rgb .8 } }
#declare Word = text { internal 2 "povtrace" .6, 0 }
#declare Wide = max_extent(Word).x;
difference {
    superellipsoid { <.2, .2> scale <3.3, .3, 2> }
    object { Word rotate 90*x scale 1.05 translate <-Wide*.525 - .3, .5, -1.45> pigment { rgb <.9, .55, .1> } }
    pigment { rgb <.16, .22, .33> }
    finish { specular .6 roughness .02 reflection .06 }
}
object { Word scale <1.05, 1.25, .7> translate <-Wide*.525 - .3, .3, .5> pigment { rgb <.93, .6, .15> } finish { specular .8 roughness .01 reflection { .25 metallic } metallic } }
intersection {
    sphere { 0, .75 }
    box { -.58, .58 }
    union { cylinder { -x, x, .36 } cylinder { -y, y, .36 } cylinder { -z, z, .36 } inverse }
    rotate <0, 35, 0> scale .8 translate <2.55, .77, -.3>
    pigment { rgb <.75, .2, .15> } finish { specular .5 }
}
