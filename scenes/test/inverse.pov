// With inverse a half space of glass is the other half: the floor's glass fills what is below, the ball is
// seen bent in it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, -0.5, 0> }
light_source { <3, 8, -6> rgb 1 }
quadric { <0, 0, 0>, <0, 0, 0>, <0, -1, 0>, 0 inverse pigment { rgbf <0.8, 0.9, 1, 0.9> }
    interior { ior 1.33 } }
sphere { <-0.8, -0.3, 0>, 1 inverse pigment { rgb <0.9, 0.6, 0.4> } }
box { <0.6, -1.5, -0.5>, <1.8, 0.7, 0.8> pigment { rgb <0.5, 0.8, 0.5> } }
box { <-9, -2.2, -6>, <9, -2, 9> pigment { rgb <0.9, 0.8, 0.6> } }
