// A surface is lit on the side that is seen only: the polygon's back, and a room seen from inside its wall.
camera { location <0, 1, -3> look_at <0, 0, 0> }
light_source { <2, 2.4, 2> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 5 pigment { color rgb <0.6, 0.7, 0.9> } }
polygon { 5, <-1, -1, 0>, <0.6, -1, 0>, <0.6, 0.8, 0.4>, <-1, 0.8, 0.4>, <-1, -1, 0>
    pigment { color rgb <0.9, 0.5, 0.3> } }
