#version 3.7;
// Cylinders and cones without caps as members: what is cut out ends where they end, and no cap is drawn there.
global_settings { assumed_gamma 1 }
camera { location <1, 3, -6> look_at <0, 0, 0> angle 42 }
light_source { <5, 8, -6> color rgb 1 }
background { color rgb <0.2, 0.3, 0.4> }
difference {
  box { <-1, -1, -1>, <1, 1, 1> pigment { color rgb <0.9, 0.3, 0.2> } }
  cylinder { <0, 0, 0>, <0, 2, 0>, 0.6 open pigment { color rgb <0.3, 0.8, 0.4> } }
  cone { <0.3, 0, -2>, 0.7, <0.3, 0, -0.5>, 0.2 open pigment { color rgb <0.3, 0.4, 0.9> } }
}
difference {
  cylinder { <-2.3, -1, 0>, <-2.3, 0.8, 0>, 0.8 open pigment { color rgb <0.9, 0.8, 0.3> } }
  sphere { <-2.3, 0.2, -0.8>, 0.6 pigment { color rgb <0.5, 0.9, 0.9> } }
}
intersection {
  cone { <2.2, -1, 0>, 0.9, <2.2, 1, 0>, 0.3 open }
  box { <1, -0.6, -2>, <4, 0.7, 2> }
  pigment { color rgb <0.8, 0.5, 0.9> }
}
merge {
  cylinder { <-1, -0.7, -2>, <1, -0.7, -2>, 0.2 open }
  sphere { <-1, -0.7, -2>, 0.2 }
  cylinder { <0, -0.9, -2>, <0, -0.2, -2>, 0.15 open }
  pigment { color rgb <0.9, 0.9, 0.9> }
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
