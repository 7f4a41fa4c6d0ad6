// The same box left where it is, and moved by a vector and by a number.
camera { location <0, 2, -7> look_at <0, 0, 0> }
light_source { <4, 8, -8> color rgb <1, 1, 1> }
box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> pigment { color rgb <0.6, 0.6, 0.6> } }
box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> translate <-2, 0.5, 1> pigment { color rgb <0.9, 0.4, 0.4> } }
box { <-0.5, -0.5, -0.5>, <0.5, 0.5, 0.5> translate 1.2 pigment { color rgb <0.4, 0.9, 0.4> } }
