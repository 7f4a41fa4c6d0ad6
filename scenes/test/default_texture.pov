// Textures of objects that have none, of parts, and of what begins with the default.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#default { texture { pigment { crackle color_map { [0 rgb 0] [.2 rgb <.9, .8, .2>] [1 rgb <.2, .2, .9>] } scale .4 } finish { ambient .3 } } }
plane { y, -1 }
sphere { 0, 1 scale 1.6 translate <0, .5, 2> }
sphere { <-2, 0, -1>, .5 pigment { rgb 1 } }
sphere { <-1, 0, -2>, .4 pigment { color_map { [0 rgb 1] [1 rgb 0] } } }
sphere { <1, 0, -2>, .4 pigment { cells } }
#default { finish { ambient 0 diffuse .9 } }
#default { pigment { checker rgb <1, .5, 0>, rgb .9 } }
sphere { <2, 0, -1>, .5 }
union { sphere { <.7, 1.4, -1>, .4 } sphere { <-.4, 1.4, -1>, .3 pigment { rgb x } scale 1.2 } rotate y*10 }
// Without a texture an object has the default of where it is placed; modifiers of a normal wait for a pattern.
#declare Late = sphere { <0, -.6, -2.5>, .3 }
#default { pigment { rgb <.3, .8, .4> } finish { phong .5 } }
object { Late }
object { Late pigment { rgb 1 scale .3 } pigment { checker } translate -x*1.2 }
#default { normal { bump_size 1.5 scale .2 } }
object { Late normal { bumps } translate x*1.2 }
