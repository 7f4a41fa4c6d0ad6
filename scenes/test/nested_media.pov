// A bubble of air and a core of denser glass inside a ball of glass: each surface bends by the two media that
// meet there.
global_settings { max_trace_level 10 }
camera { location <0, 0.5, -5> look_at <0, 0, 0> }
light_source { <3, 6, -5> color rgb <1, 1, 1> }
sphere { <0, 0, 0>, 1.4 pigment { color rgbf <1, 1, 1, 0.95> } interior { ior 1.4 } }
sphere { <-0.5, 0, 0>, 0.45 pigment { color rgbf <1, 1, 1, 1> } }
sphere { <0.6, 0.1, 0>, 0.5 pigment { color rgbf <1, 0.9, 0.8, 0.9> } interior { ior 1.8 } }
box { <-9, -1.8, -4>, <9, -1.6, 9> pigment { color rgb <0.5, 0.7, 0.9> } finish { diffuse 0.9 } }
