// Loops that cross themselves follow the even-odd rule: a bow tie and a five-pointed star with its middle
// open.
camera { location <0, 0, -4> look_at <0, 0, 0> }
light_source { <1, 2, -8> color rgb <1, 1, 1> }
polygon { 5, <-1.9, -0.8>, <-0.3, 0.8>, <-0.3, -0.8>, <-1.9, 0.8>, <-1.9, -0.8>
    pigment { color rgb <0.9, 0.3, 0.5> } }
polygon { 6, <1, 1>, <1.6, -0.8>, <0.05, 0.3>, <1.95, 0.3>, <0.4, -0.8>, <1, 1>
    pigment { color rgb <0.9, 0.8, 0.3> } }
