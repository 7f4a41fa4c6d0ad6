// A sphere with nothing but a radius lies about the origin, as an example of the course has it.
camera { location <0, 1, -4> look_at <0, 0, 0> }
light_source { <4, 6, -6> color rgb <1, 1, 1> }
sphere { 1.2 pigment { color rgb <0.3, 0.7, 0.9> } }
