// Wood, marble and glass in soft light.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 4.2, -9> look_at <0, 1.15, 0> angle 38 }
light_source { <-6, 9, -5> rgb 1.15 area_light 3*x, 3*z, 5, 5 adaptive 1 circular orient jitter }
light_source { <8, 5, -6> rgb .2 shadowless }
background { rgb <.32, .34, .38> }
plane { z, 6 pigment { rgb <.5, .48, .45> } finish { ambient .15 } }
box { <-7, -.4, -4>, <7, 0, 5>
    pigment { wood turbulence .06 color_map { [0 rgb <.42, .24, .12>] [.7 rgb <.55, .34, .18>] [1 rgb <.3, .16, .07>] } rotate 88*y scale .35 }
    finish { ambient .08 specular .25 roughness .03 reflection .04 } }
lathe { cubic_spline 9, <0, -.2>, <0, 0>, <.75, .02>, <.95, .9>, <.5, 1.8>, <.35, 2.3>, <.6, 2.75>, <.68, 2.8>, <.7, 3>
    translate <-2.1, 0, .8>
    pigment { marble turbulence .9 scale .5 rotate 40*z color_map { [0 rgb .92] [.6 rgb .8] [.9 rgb .55] [1 rgb .3] } }
    finish { ambient .08 diffuse .8 specular .5 roughness .008 reflection .05 } }
sphere { <.25, .9, -.3>, .9 pigment { rgbf <.97, .99, .98, .97> } finish { ambient 0 diffuse 0 specular .9 roughness .002 reflection { .03, .6 fresnel } conserve_energy } interior { ior 1.5 } }
superellipsoid { <.25, .25> scale .65 rotate 30*y translate <2.3, .65, .6>
    pigment { wood turbulence .1 scale .3 rotate <20, 60, 0> color_map { [0 rgb <.75, .55, .32>] [1 rgb <.55, .35, .17>] } } finish { ambient .08 specular .3 } }
sphere { <1.35, .35, -1.6>, .35 pigment { granite scale .4 color_map { [0 rgb <.25, .3, .28>] [.6 rgb <.5, .55, .5>] [1 rgb .8] } } finish { ambient .08 specular .6 roughness .01 } }
