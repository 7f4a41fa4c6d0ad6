// Planes: a floor, a wall that is turned by its normal, and one that cuts a sphere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <3, 2, -8> look_at <0, .5, 0> angle 50 }
light_source { <10, 20, -10> rgb 1 }
plane { <0, 1, 0>, 0 pigment { rgb <.5, .6, .4> } finish { reflection .2 } }
plane { <0, 0, -1>, -12 pigment { rgb <.7, .8, 1> } finish { ambient .4 } }
difference {
    sphere { <0, 1, 0>, 1 }
    plane { <-1, 1, -1>, .6 }
    pigment { rgb <1, .3, .2> }
    finish { phong 1 }
}
plane { <0, 2, 0>, 1 rotate <0, 0, 80> translate <-4, 0, 0> pigment { rgb <.8, .4, .6> } }
sphere { <2, .6, -1>, .6 pigment { rgbf <.8, 1, .8, .9> } interior { ior 1.5 } }
