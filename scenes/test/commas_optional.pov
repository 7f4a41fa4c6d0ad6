// Commas between the items of a list may be left out (but not before a sign: POV-Ray takes "1 -5" for a
// difference).
camera { location <0 1, -5> look_at <0 0 0> }
light_source { <4 6, -6> color rgb <1 1 1> }
sphere { <-1 0 0> 0.9 pigment { color rgb <0.9 .5 0.4> } }
box { <0.2, -0.8, -.5> <1.4, 0.6 0.5> pigment { color rgb <0.4, 0.6 0.9> } }
cone { <1.9, -0.8 0> 0.4 <1.9 0.8 0> 0.1 pigment { color rgb <.5 .9 .5> } }
