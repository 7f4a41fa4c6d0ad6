// Three goblets of glass, one with wine, in the light of a window.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2.4, -7> look_at <0, 1.05, 0> angle 36 }
light_source { <-6, 6, -2> rgb 1.1 area_light 2.4*y, 2.4*z, 5, 5 jitter }
background { rgb <.45, .5, .56> }
plane { y, 0 pigment { rgb <.55, .5, .44> } finish { ambient .08 specular .2 roughness .02 reflection .05 } }
plane { z, 5 pigment { rgb <.6, .58, .52> } finish { ambient .1 } }
#declare Glass = material {
    texture { pigment { rgbf <.97, .99, .98, .96> } finish { ambient 0 diffuse .02 specular .9 roughness .003 phong .3 reflection { 0, 1 fresnel } conserve_energy } }
    interior { ior 1.5 fade_distance 2 fade_power 2 fade_color <.8, .9, .85> }
}
#declare Goblet = union {
    difference { sphere { 1.55*y, .62 } sphere { 1.57*y, .57 } box { <-1, 1.85, -1>, <1, 3, 1> } }
    merge { cylinder { .05*y, .98*y, .06 } cone { 0, .5, .08*y, .12 } }
    material { Glass }
}
object { Goblet translate <-1.5, 0, .4> }
object { Goblet translate <.1, 0, -.5> }
object { Goblet translate <1.6, 0, .5> }
intersection { sphere { 1.57*y, .565 } plane { y, 1.62 } translate <.1, 0, -.5>
    pigment { rgbf <.75, .08, .12, .9> } finish { ambient 0 diffuse .05 specular .6 reflection { 0, 1 fresnel } conserve_energy } interior { ior 1.34 } }
