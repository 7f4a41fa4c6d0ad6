// A pattern of four colours: turned, moved with its object, from names; and the shadow of patterned glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -8> look_at <0, .5, 0> }
light_source { <5, 10, -6> rgb 1 }
background { rgb <.3, .5, .8> }
#declare Panes = texture { pigment { square rgbf <1, 0, 0, .9>, rgbt <0, 0, 0, .8>, rgbft <.2, .9, .2, .5, .4> rgb <1, 1, 0> scale .5 } translate .2 }
box { <-40, -2, -40>, <40, -1, 40> pigment { rgb 1 } }
sphere { <0, .5, 0>, 1.3 pigment { square rgb <1, 0, 0>, <0, 1, 0>, rgb <.2, .3, 1> color rgb .9 scale .4 } rotate <30, 20, 10> }
box { <-3, -.9, -1>, <-1.6, 1.5, 1> texture { pigment { square scale .5 rotate x*90 translate .1 } finish { phong .6 } } }
union {
    cylinder { <2.5, -.9, 0>, <2.5, 1.4, 0>, .8 }
    cone { <1, -.9, -2>, .7, <1, .6, -2.2>, .2 }
    texture { Panes }
    rotate y*10
    translate -z
}
