// Scaling by a vector makes ellipsoids and squeezed cones; after a rotation it shears. A number scales all
// three.
camera { location <0, 1.5, -6> look_at <0, 0, 0> }
light_source { <4, 8, -8> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 1 scale <0.5, 1.2, 0.8> translate <-2, 0, 0> pigment { color rgb <0.9, 0.5, 0.6> } }
box { <-0.6, -0.6, -0.6>, <0.6, 0.6, 0.6> rotate <0, 0, 45> scale <1, 0.6, 1>
    pigment { color rgb <0.5, 0.8, 0.6> } }
cone { <0, -1, 0>, 1, <0, 1, 0>, 0.2 scale 0.5 scale <1, 2, 0.6> translate <2, 0, 0>
    pigment { color rgb <0.5, 0.6, 0.9> } }
