// A glass ball and a glass slab bend what is behind them, by Snell's law.
camera { location <0, 0.6, -5> look_at <0, 0, 0> }
light_source { <3, 6, -5> color rgb <1, 1, 1> }
sphere { <-1, 0, 0>, 0.9 pigment { color rgbf <1, 1, 1, 0.95> } interior { ior 1.5 } }
box { <0.3, -0.9, -0.4>, <1.8, 0.9, 0.4> rotate <0, 30, 0>
    pigment { color rgbf <0.9, 1, 0.95, 0.9> } interior { ior 1.33 } }
cylinder { <-4, -0.2, 3>, <4, 0.4, 3>, 0.4 pigment { color rgb <0.9, 0.5, 0.3> } finish { diffuse 0.9 } }
box { <-6, -1.2, -4>, <6, -1, 9> pigment { color rgb <0.4, 0.5, 0.7> } }
