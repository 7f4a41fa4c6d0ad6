// The camera is inside a block of glass with a cooler slab in front; what is seen is bent on leaving the
// block.
camera { location <0, 0.5, -5> look_at <0, 0, 0> }
light_source { <3, 6, -9> color rgb <1, 1, 1> }
box { <-9, -9, -8>, <9, 9, -2> pigment { color rgbf <0.95, 1, 1, 1> } interior { ior 1.3 } }
sphere { <-1, 0, 1>, 0.9 pigment { color rgb <0.9, 0.4, 0.3> } }
box { <0.4, -0.9, 0.4>, <1.8, 0.6, 2> pigment { color rgb <0.4, 0.7, 0.9> } }
