// Negative factors mirror: the normals still point out, and the shading is that of the mirrored shape.
camera { location <0, 1.5, -6> look_at <0, 0, 0> }
light_source { <4, 8, -8> color rgb <1, 1, 1> }
cone { <0, 0, 0>, 0.8, <0.7, 1.2, -0.3>, 0.2 translate <0.6, 0, 0> pigment { color rgb <0.9, 0.6, 0.4> } }
cone { <0, 0, 0>, 0.8, <0.7, 1.2, -0.3>, 0.2 translate <0.6, 0, 0> scale <-1, 1, 1>
    pigment { color rgb <0.5, 0.7, 0.9> } }
box { <-0.5, 0.2, -0.5>, <1.5, 0.8, 0.5> rotate <0, 30, 10> scale <-1, -1.5, 1>
    pigment { color rgb <0.6, 0.9, 0.6> } }
