// Colours of pigments at points, in the language.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#include "functions.inc"
#declare Field = pigment { gradient x pigment_map { [0 rgb <1, .2, 0>] [1 checker rgb 1, rgb <0, .2, .9> scale .5] } turbulence .3 scale 4 }
#declare F = function { pigment { Field } }
#for (I, -6, 6) #for (J, -3, 3)
    sphere { <I*.4, J*.4 + .4, 0>, .2 pigment { color eval_pigment(Field, <I*.4, J*.4, .3>) } }
#end #end
plane { z, 1 pigment { rgb F(.3, .2, .1) } }
plane { y, -1.1 pigment { rgb <F(1, 0, 0).red, F(2, 0, .3).green, F(3, 1, 0).blue> } }
