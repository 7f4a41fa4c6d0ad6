// Rotations turn about x, then y, then z, left-handed; two of them act in the order written.
camera { location <0, 2, -7> look_at <0, 0, 0> }
light_source { <4, 8, -8> color rgb <1, 1, 1> }
box { <-0.9, -0.2, -0.4>, <0.9, 0.2, 0.4> rotate <40, 50, 20> translate <-2, 0, 0>
    pigment { color rgb <0.9, 0.6, 0.3> } }
box { <-0.9, -0.2, -0.4>, <0.9, 0.2, 0.4> rotate <0, 0, 20> rotate <0, 50, 0> rotate <40, 0, 0>
    pigment { color rgb <0.5, 0.7, 0.9> } }
box { <-0.9, -0.2, -0.4>, <0.9, 0.2, 0.4> translate <2, 0, 0> rotate <0, 0, -25>
    pigment { color rgb <0.6, 0.9, 0.5> } }
