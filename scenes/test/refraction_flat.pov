// Glass boxes of three refractive indices over a floor; equal indices (the default 1) do not bend.
camera { location <0, 3, -6> look_at <0, 0, 0> }
light_source { <3, 8, -5> color rgb <1, 1, 1> }
box { <-2.2, -1, -0.6>, <-0.9, 0.4, 0.6> pigment { color rgbf <1, 0.8, 0.8, 0.8> } }
box { <-0.6, -1, -0.6>, <0.6, 0.4, 0.6> pigment { color rgbf <0.8, 1, 0.8, 0.8> } interior { ior 1.2 } }
box { <0.9, -1, -0.6>, <2.2, 0.4, 0.6> pigment { color rgbf <0.8, 0.8, 1, 0.8> } interior { ior 2.2 } }
box { <-5, -1.4, -3>, <5, -1.2, 5> pigment { color rgb <0.9, 0.9, 0.8> } }
