// All words of the course dialect in one picture.
global_settings { ambient_light rgb <0.3, 0.3, 0.4> max_trace_level 6 adc_bailout 0.002 }
camera { location <0, 3, -8> look_at <0, 0.2, 0> angle 45 up <0, 1, 0> right <1.33333, 0, 0> }
light_source { <-6, 9, -6> color rgb <1, 0.95, 0.85> }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 1 pigment { color rgb <0.5, 0.55, 0.6> }
    finish { reflection 0.15 } }
sphere { <-1.9, 0, 0>, 1 pigment { color rgbf <0.9, 1, 0.95, 0.9> }
    finish { phong 0.9 phong_size 90 } interior { ior 1.45 } }
box { <-0.6, -1, -0.6>, <0.6, 0.2, 0.6> rotate <0, 35, 0> pigment { colour red 0.8 green 0.4 blue 0.3 } }
cone { <0, 0.2, 0>, 0.5, <0, 1.3, 0>, 0 pigment { color rgb <0.8, 0.7, 0.3> } }
cylinder { <2, -1, 0.5>, <2, 1, 0.5>, 0.6 pigment { color rgb <0.3, 0.5, 0.8> }
    finish { ambient 0.3 diffuse 0.5 phong 0.4 metallic 0 } }
polygon { 4, <-1, 0, 2>, <1, 0, 2>, <0, 2, 2>, <-1, 0, 2> scale <2, 1, 1>
    pigment { color rgbf <0.9, 0.3, 0.5, 0.5> } }
