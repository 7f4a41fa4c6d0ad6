/* Block comments /* nest, */ and may hold // or " or { without harm. */ // A line comment hides /* this.
camera { /* in between */ location <0, 1, /**/ -4> look_at <0, 0, 0> } // to the end }
light_source { <4, 6, -6> color rgb <1, 1, 1> }
/* sphere { <0, 0, 0>, 2 /* hidden */ pigment { color rgb 1 } } */
sphere { <0, 0, 0>, 1 /* * / ** */ pigment { color rgb <0.6, 0.9, 0.4> } }
