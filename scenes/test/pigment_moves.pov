// Transformations, warps and turbulence of pigments in the order of the text, and with those of a texture and an object.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -6> look_at <0, .3, 0> }
light_source { <4, 8, -5> rgb 1 }
#declare G = pigment { gradient x color_map { [.5 rgb <.9, .7, .2>] [.5 rgb <.2, .2, .6>] } scale .3 }
plane { y, -1 pigment { G turbulence .3 rotate y*30 } }
sphere { <-2.2, 0, 0>, .8 pigment { G warp { turbulence .4 } scale <1, 2, 1> rotate z*40 } }
sphere { <-.5, 0, 0>, .8 pigment { G scale <1, 2, 1> warp { turbulence .4 } rotate z*40 } }
sphere { 0, .8 texture { pigment { G rotate z*30 warp { repeat y*.4 offset x*.1 } } scale .7 } rotate z*20 translate <1.2, 0, 0> }
union { sphere { 0, .5 } sphere { x, .5 scale .8 } pigment { G rotate y*90 turbulence .2 octaves 2 } rotate x*40 translate <-.4, 1.5, 0> }
sphere { 0, .5 pigment { checker rgb x, rgb 1 scale .2 } rotate y*20 translate <2, 1.4, 0> pigment { rotate 45 } }
