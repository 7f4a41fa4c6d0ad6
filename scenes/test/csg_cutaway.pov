// Cut faces with the textures of the solids that were cut, where these overlap with the mean of them; a bound that clips.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,4,-8> look_at <0,.3,0> angle 45 }
light_source { <10,20,-10> rgb 1 }
plane { y, -1.2 pigment { rgb <.5,.6,.7> } }
difference {
    union {
        sphere { -.4*x, .8 pigment { rgb <1,.6,.2> } }
        sphere { .5*x, .9 pigment { checker rgb <.3,.8,.3> rgb 1 scale .3 rotate y*20 } }
    }
    box { <-2,-.4,-3>, <2,2,.1> }
    cutaway_textures
    rotate y*-25 translate -1.8*x
}
intersection {
    sphere { 0, 1.1 pigment { rgb <.9,.3,.5> } }
    plane { y, .4 }
    cutaway_textures
    rotate x*-20 translate 1*x
}
box { -.8, .8 bounded_by { sphere { 0, 1.1 } } clipped_by { bounded_by } pigment { rgb <.6,.7,.9> } rotate y*30 translate 3.2*x }
