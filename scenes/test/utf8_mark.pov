// A byte-order mark in front, UTF-8 in comments: α, ∞, 🔮.
camera { location <0, 1, -4> look_at <0, 0, 0> }
light_source { <4, 6, -6> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 1.2 pigment { color rgb <0.9, 0.8, 0.5> } }
