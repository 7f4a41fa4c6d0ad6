// The angle is the horizontal one, whatever `right` is; the order of the items does not matter.
camera { angle 30 right <1.6, 0, 0> up <0, 1.2, 0> look_at <0, 0, 0> location <3, 4, -8> }
light_source { <4, 8, -8> color rgb <1, 1, 1> }
box { <-1, -1, -1>, <1, 1, 1> pigment { color rgb <0.8, 0.7, 0.4> } }
sphere { <0, 1.6, 0>, 0.6 pigment { color rgb <0.6, 0.4, 0.8> } }
