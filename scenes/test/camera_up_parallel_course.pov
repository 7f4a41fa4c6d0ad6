// In the course dialect x is the vertical where `up` lies along the view.
camera { location <0, 6, 0> look_at <0, 0, 0> up <0, 1, 0> }
light_source { <4, 8, -3> color rgb <1, 1, 1> }
box { <0.2, -1, -1.5>, <1.6, 0.5, 0.5> pigment { color rgb <0.8, 0.5, 0.4> } }
sphere { <-1, 0, 1>, 0.7 pigment { color rgb <0.4, 0.8, 0.5> } }
