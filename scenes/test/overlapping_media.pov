// Two overlapping slabs of glass: the ray is in the one that it entered last; leaving the other one there
// bends nothing.
global_settings { max_trace_level 10 }
camera { location <0, 3.5, -5> look_at <0, -0.4, 0> }
light_source { <2, 8, -5> color rgb <1, 1, 1> }
box { <-1.8, -0.3, -1>, <0.6, 0.3, 1> pigment { color rgbf <1, 0.9, 0.8, 0.9> } interior { ior 1.5 } }
box { <-0.6, 0, -0.8>, <1.8, 0.6, 1.2> pigment { color rgbf <0.8, 0.9, 1, 0.9> } interior { ior 1.2 } }
cylinder { <-3, -1, -0.4>, <3, -1, 0.8>, 0.3 pigment { color rgb <0.9, 0.6, 0.3> } }
