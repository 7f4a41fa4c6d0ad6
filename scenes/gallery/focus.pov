// Marbles in two rows, seen through a wide lens that is sharp on the third; the lamp is large.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <-1.6, 1.7, -5> look_at <.3, .35, 0> angle 34 aperture .35 blur_samples 40 focal_point <-.4, .4, -.4> }
light_source { <-4, 7, -3> rgb 1 area_light 2.5*x, 2.5*z, 6, 6 circular orient jitter }
background { rgb <.2, .24, .3> }
plane { y, 0 pigment { checker rgb <.75, .7, .62>, rgb <.3, .22, .18> scale .7 } finish { ambient .05 specular .15 reflection .06 } }
#declare Glass = material {
    texture { pigment { rgbf <.95, .99, .97, .97> } finish { ambient 0 diffuse 0 specular .8 roughness .004 reflection { 0, 1 fresnel } conserve_energy } }
    interior { ior 1.5 }
}
#for (I, 0, 5)
    sphere { <-1.6 + I*.75, .4, -2 + I*1.1>, .4 pigment { rgb <.85 - I*.12, .3 + I*.06, .12 + I*.13> } finish { ambient .05 phong .6 phong_size 60 } }
    sphere { <-.3 + I*.75, .32, -2.3 + I*1.1>, .32 #if (mod(I, 2)) material { Glass } #else pigment { rgb <.9, .7, .35> } finish { ambient .05 diffuse .3 specular .7 roughness .03 metallic reflection { .5 metallic } } #end }
#end
