// A table of numbers as columns and the surface through them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <9, 9, -14> look_at <0, 1.2, 0> angle 44 }
light_source { <-10, 16, -8> rgb 1 area_light 4*x, 4*z, 3, 3 jitter }
light_source { <10, 6, -10> rgb .25 shadowless }
background { rgb 1 }
#declare N = 12;
#declare F = function (x, z) { 1.2 + .9*sin(x*.9)*cos(z*.7) + .35*cos(x*2.1 + z) }
#macro Shade(V) rgb <.15 + .3*V, .25 + .18*V, .75 - .26*V> #end
box { <-4.2, -.1, -4.2>, <4.2, 0, 4.2> pigment { rgb .93 } }
#for (I, 0, N - 1)
    #for (J, 0, N - 1)
        #local X = (I - (N - 1)/2)*.66;
        #local Z = (J - (N - 1)/2)*.66;
        #local V = F(X, Z);
        box { <X - .2, 0, Z - .2>, <X + .2, V, Z + .2> pigment { Shade(V) } finish { specular .25 } }
    #end
#end
height_field { function 120, 120 { max(0, F((x - .5)*8, (.5 - y)*8)/4) } smooth translate <-.5, 0, -.5> scale <8, 4, 8> translate .9*y
    pigment { rgbt <.95, .6, .2, .55> } finish { specular .4 } no_shadow }
#for (K, 0, 4)
    cylinder { <-4.2, K*.6, 4.2>, <4.2, K*.6, 4.2>, .015 pigment { rgb .4 } }
    text { internal 1 str(K*.6, 0, 1) .02, 0 scale .42 translate <4.35, K*.6 - .12, 4.2> pigment { rgb .2 } }
#end
