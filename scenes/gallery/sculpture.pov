// A gyroid in a ball: the zero of a formula, held by another.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -6.2> look_at <0, 1.15, 0> angle 38 }
light_source { <-5, 8, -6> rgb 1 area_light 2*x, 2*z, 3, 3 jitter }
light_source { <6, 3, -3> rgb <.2, .22, .3> shadowless }
background { rgb <.2, .21, .24> }
plane { y, -.15 pigment { rgb .55 } finish { reflection .08 } }
#declare Gyroid = function (x, y, z) { abs(sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x)) - .28 }
isosurface {
    function { max(Gyroid(x*4.4, y*4.4, z*4.4)/4.4, sqrt(x*x + y*y + z*z) - 1.25) }
    contained_by { sphere { 0, 1.3 } }
    accuracy .0005 max_gradient 2
    rotate <15, 30, 0> translate 1.3*y
    pigment { rgb <.8, .45, .22> } finish { ambient .06 diffuse .7 specular .7 roughness .02 metallic reflection { .08 metallic } }
}
cylinder { -.15*y, .12*y, .8 pigment { rgb .12 } finish { specular .4 reflection .05 } }
