// Bars of white and black behind a prism and a ball of glass that bends each colour by its own.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 1.6, -6.5> look_at <0, .85, 0> angle 36 }
light_source { <-5, 8, -5> rgb .9 area_light 2*x, 2*z, 4, 4 jitter }
background { rgb <.05, .05, .07> }
plane { y, 0 pigment { rgb <.35, .36, .4> } finish { ambient .05 reflection .08 } }
box { <-5, 0, 3>, <5, 3.4, 3.1> pigment { gradient x color_map { [.5 rgb .03] [.5 rgb 1] } scale .5 } finish { ambient .6 diffuse .4 } }
#declare Flint = material {
    texture { pigment { rgbf <1, 1, 1, .98> } finish { ambient 0 diffuse 0 specular .7 roughness .002 reflection { 0, 1 fresnel } conserve_energy } }
    interior { ior 1.62 dispersion 1.06 dispersion_samples 9 }
}
prism { linear_sweep linear_spline 0, 1.7, 4, <-.85, -.5>, <.85, -.5>, <0, 1>, <-.85, -.5> rotate 25*y translate <-1.15, .02, .2> material { Flint } }
sphere { <1.2, .85, 0>, .83 material { Flint } }
