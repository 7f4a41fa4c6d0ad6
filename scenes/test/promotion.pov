// A number where a vector or a colour stands is taken for each component.
camera { location <0, 1, -5> look_at 0 }
light_source { <4, 6, -6> color rgb 1 }
box { -0.8, 0.6 rotate 20 translate <-1, 0, 0> pigment { color rgb 0.7 } }
sphere { 0, 1 scale 0.8 translate <1.2, 0, 0> pigment { color rgb <0.9, 0.7, 0.2> } }
