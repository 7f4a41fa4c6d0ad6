// A polygon with a hole and an island in it: each repeated first point closes a loop.
camera { location <0, 0, -4> look_at <0, 0, 0> }
light_source { <1, 2, -8> color rgb <1, 1, 1> }
polygon { 14, <-1.4, -1.1>, <1.4, -1.1>, <1.2, 1.2>, <-1.3, 1>, <-1.4, -1.1>,
    <-0.9, -0.7>, <0.9, -0.7>, <0.8, 0.8>, <-0.9, 0.7>, <-0.9, -0.7>,
    <-0.4, -0.3>, <0.5, -0.3>, <0, 0.5>, <-0.4, -0.3>
    pigment { color rgb <0.4, 0.9, 0.5> } rotate <0, 20, 0> }
box { <-3, -2, 2>, <3, 2, 2.2> pigment { color rgb <0.7, 0.6, 0.5> } }
