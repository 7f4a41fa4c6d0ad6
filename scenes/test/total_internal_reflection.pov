// From inside glass, beyond the critical angle, the wall is a perfect mirror: it shows the ball a second
// time.
global_settings { ambient_light rgb <1, 1, 1> }
camera { location <-3.5, 0.6, -3> look_at <0, 0, 0> }
light_source { <-3, 3, -4> color rgb <1, 1, 1> }
box { <-9, -4, -9>, <9, 4, 0> pigment { color rgbf <1, 1, 1, 0.9> }
    finish { ambient 0.2 reflection 0.3 } interior { ior 1.5 } }
sphere { <1, 0, -1.5>, 0.8 pigment { color rgb <0.9, 0.6, 0.3> } finish { ambient 0.3 } }
box { <-6, -3, 3>, <6, 3, 4> pigment { color rgb <0.3, 0.6, 0.5> } finish { ambient 0.6 } }
