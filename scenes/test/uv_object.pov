// uv_mapping of an object, before its texture: in a texture, in layers, in a material, moved.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 8, -6> rgb 1 }
#declare Checks = texture { pigment { checker rgb <.9, .9, .8> rgb <.7, .2, .1> scale .1 } finish { ambient .1 } }
box { -.5, .5 uv_mapping texture { Checks } rotate 30*y translate -1.8*x }
sphere { 0, .6 uv_mapping texture { Checks } texture { pigment { gradient x color_map { [.5 rgbt 1] [.5 rgbt <.2, .3, .9, .4>] } scale .25 } } }
torus { .45, .2 uv_mapping material { texture { Checks } } rotate -50*x translate 1.8*x }
bicubic_patch {
  type 1 flatness .001 u_steps 4 v_steps 4
  <-2, -1, 0>, <-.7, -1.2, 0>, <.7, -.8, 0>, <2, -1, 0>, <-2, -1, 1>, <-.7, -.8, 1>, <.7, -1.2, 1>, <2, -1, 1>,
  <-2, -1, 2>, <-.7, -1, 2>, <.7, -1, 2>, <2, -1, 2>, <-2, -1, 3>, <-.7, -1, 3>, <.7, -1, 3>, <2, -1, 3>
  uv_mapping texture { Checks }
}
