// A light between objects: what stands beyond it casts no shadow back, and what it shines on from behind
// stays dark.
camera { location <0, 1.5, -7> look_at <0, 0, 0> }
light_source { <0, 0.5, 0> color rgb <1, 1, 1> }
sphere { <-2.2, 0, 0>, 0.8 pigment { color rgb <0.9, 0.6, 0.4> } }
sphere { <2.2, 0, 0>, 0.8 pigment { color rgb <0.4, 0.6, 0.9> } }
box { <-4, -1.2, -2>, <4, -1, 4> pigment { color rgb <0.7, 0.7, 0.7> } }
