// A lens, a prism and a drop on a bench, each of glass with a ruler behind it.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 2.6, -9> look_at <0, 1.05, 0> angle 40 }
light_source { <-5, 9, -6> rgb 1 }
light_source { <6, 7, -4> rgb .4 }
background { rgb <.6, .66, .72> }
plane { y, 0 pigment { rgb <.25, .27, .3> } finish { specular .2 reflection .1 } }
box { <-5, .2, 3>, <5, 2.8, 3.1> pigment { checker rgb .95, rgb <.1, .2, .4> scale .35 } finish { ambient .3 } }
#declare Glass = material {
    texture { pigment { rgbf <.98, .99, 1, .97> } finish { ambient 0 diffuse 0 specular .8 roughness .003 reflection { .02, .7 fresnel } conserve_energy } }
    interior { ior 1.52 }
}
intersection { sphere { -2.2*z, 2.5 } sphere { 2.2*z, 2.5 } cylinder { -z, z, 1 } rotate 12*y translate <-2.3, 1.15, 0> material { Glass } }
prism { linear_sweep linear_spline 0, 1.9, 4, <-.9, -.5>, <.9, -.5>, <0, 1>, <-.9, -.5> rotate 20*y translate <.1, .1, .2> material { Glass } }
difference { sphere { 0, .95 } sphere { 0, .55 } translate <2.5, 1.05, 0> material { Glass } }
#for (I, -1, 1)
    cylinder { <I*2.4, 0, 0>, <I*2.4, .1, 0>, .5 pigment { rgb <.7, .5, .2> } finish { specular .5 reflection .1 } }
#end
