// Solids of planes alone, turned and cut: finite though none of their members is.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 45 }
light_source { <4, 6, -6> rgb 1 }
background { rgb <.2, .3, .4> }

#declare Crystal = intersection {
    plane { <1, .2, 0>, .5 } plane { <-.3, 1, .4>, .7 } plane { <-1, 0, .3>, .5 } plane { <0, -1, .1>, .6 }
    plane { <.2, .1, 1>, .5 } plane { <0, .3, -1>, .5 } plane { <1, 1, -1>, .7 }
}
object { Crystal pigment { rgb <.8, .5, .3> } rotate <20, 30, 0> translate -1.6*x }
difference {
    object { Crystal }
    plane { <-1, -1, 1>, -.3 }
    sphere { <.2, .3, -.4>, .3 }
    pigment { rgb <.4, .6, .8> } rotate 70*y
}
object { Crystal clipped_by { plane { <1, .5, 0>, .1 } } pigment { rgb <.6, .8, .4> } rotate -40*y translate 1.6*x }
