// Every way to write a number: .5, 5., 1e-3, +.2, 25E-1.
camera { location <0., +1, -.5e1> look_at <1e-3, -.0, 0> }
light_source { <4, 60.0e-1, -6.> color rgb <1., +1, 1e0> }
sphere { <-1., 0, 0>, +.9 pigment { color rgb <.9, 50E-2, .4> } }
box { <+.2, -8e-1, -.5>, <14.E-1, .6, 5e-1> pigment { color rgb <4.e-1, .6, 9e-1> } }
