// A light's colour multiplies what the surface sends back, and its highlight. Lights do not fade with
// distance.
camera { location <0, 1, -5> look_at <0, 0, 0> }
light_source { <600, 800, -900> color rgb <1, 0.7, 0.3> }
sphere { <-1.1, 0, 0>, 1 pigment { color rgb <0.9, 0.9, 0.9> } }
sphere { <1.1, 0, 0>, 1 pigment { color rgb <0.3, 0.6, 0.9> } finish { phong 0.6 } }
