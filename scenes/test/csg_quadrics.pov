// Endless quadrics cut by planes: a tube, a cone, a bowl and a hyperboloid, finite together.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 42 }
light_source { <4, 6, -6> rgb 1 }
background { rgb <.2, .3, .4> }

#declare Tube = quadric { <1, 0, 1>, 0, 0, -1 }
#declare Nappes = quadric { <1, -1, 1>, 0, 0, 0 }
#declare Bowl = quadric { <1, 0, 1>, 0, <0, -1, 0>, 0 }
#declare Waist = quadric { <1, -1, 1>, 0, 0, -.2 }

difference {
    intersection { object { Tube scale .6 } plane { y, .7 } plane { -y, .5 } }
    object { Tube scale .4 }
    pigment { rgb <.8, .5, .3> } rotate 25*x translate <-2, .6, 0>
}
intersection { object { Nappes scale <.5, 1, .5> } plane { y, 0 } plane { -y, 1.2 } pigment { rgb <.4, .6, .8> } translate <-.5, .8, 0> }
difference {
    intersection { object { Bowl } plane { y, .6 } }
    object { Bowl translate .1*y }
    pigment { rgb <.6, .8, .4> } rotate -30*x translate <.8, 0, 0>
}
intersection { object { Waist } plane { z, .3 } plane { y, .7 } plane { -y, .7 } pigment { rgb <.8, .7, .4> } scale .8 translate 2.2*x }
