// In the course dialect `up` is the vertical: here it leans to the side, and its length 1 only counts for the
// aspect.
camera { location <0, 2, -6> look_at <0, 0, 0> up <0.6, 0.8, 0> }
light_source { <4, 8, -8> color rgb <1, 1, 1> }
box { <-1, -1, -1>, <1, 1, 1> pigment { color rgb <0.8, 0.7, 0.4> } }
cylinder { <0, 1, 0>, <0, 1.8, 0>, 0.3 pigment { color rgb <0.4, 0.5, 0.8> } }
