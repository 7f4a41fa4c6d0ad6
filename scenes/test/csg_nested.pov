#version 3.7;
// Differences of unions of intersections; inverse members; spheres that were squeezed after they were cut.
global_settings { assumed_gamma 1 }
camera { location <1, 3, -6> look_at <0, 0, 0> angle 42 }
light_source { <5, 8, -6> color rgb 1 }
light_source { <-6, 5, -3> color rgb <0.3, 0.3, 0.4> }
background { color rgb <0.2, 0.3, 0.4> }
difference {
  union {
    box { <-1, -1, -1>, <1, 1, 1> pigment { color rgb <0.9, 0.8, 0.3> } }
    intersection {
      sphere { <0, 1, 0>, 0.9 }
      box { <-2, 0, -2>, <2, 1.6, 2> inverse }
      pigment { color rgb <0.9, 0.2, 0.2> }
    }
    merge {
      sphere { <1, 0, -0.5>, 0.6 }
      sphere { <1.2, 0.2, 0>, 0.7 }
      pigment { color rgb <0.2, 0.7, 0.9> }
    }
  }
  union {
    cylinder { <-2, 0, 0>, <2, 0, 0>, 0.5 }
    difference { sphere { <-0.6, 0.5, -1>, 0.5 } sphere { <-0.6, 0.5, -1>, 0.25 } }
    pigment { color rgb <0.3, 0.9, 0.3> }
  }
  scale <1, 0.8, 1.2>
  rotate <0, 25, 10>
}
intersection {
  sphere { <0, 0, 0>, 1 }
  sphere { <0.4, 0.3, -0.5>, 0.7 inverse }
  quadric { <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.5 }
  pigment { color rgb <0.8, 0.4, 0.9> }
  scale <0.7, 1, 0.5>
  rotate <0, 0, 30>
  translate <-2.3, -0.2, -0.5>
}
polygon { 4, <-9, -1, -9>, <9, -1, -9>, <9, -1, 9>, <-9, -1, 9> pigment { color rgb 0.7 } }
