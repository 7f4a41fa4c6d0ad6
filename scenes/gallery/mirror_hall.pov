// A hall of mirrors: the walls to the left and right are mirrors in gilt frames, so that it goes on and on.
global_settings { assumed_gamma 1 max_trace_level 30 adc_bailout 0.001 ambient_light rgb <1, 0.9, 0.75> }
camera { location <-2.25, 1.9, -3.6> look_at <1.2, 1.3, -0.55> angle 66 }
light_source { <0, 3.3, -1> rgb <0.62, 0.52, 0.4> }
light_source { <0, 3.3, 4> rgb <0.62, 0.5, 0.36> }
light_source { <-0.5, 2.4, -5.5> rgb <0.22, 0.26, 0.34> }

// Ceiling, end walls, mirrors.
box { <-3, 4, -7>, <3, 4.2, 9> pigment { rgb <0.42, 0.40, 0.46> } finish { ambient 0.16 } }
box { <-3, -0.2, 8.8>, <3, 4.1, 9> pigment { rgb <0.45, 0.12, 0.10> } finish { ambient 0.16 } }
box { <-3, -0.2, -7>, <3, 4.1, -6.8> pigment { rgb <0.45, 0.12, 0.10> } finish { ambient 0.16 } }
box { <-2.6, -0.2, -7>, <-2.5, 4.1, 9> pigment { rgb <0.02, 0.03, 0.03> }
    finish { ambient 0 diffuse 0.3 reflection 0.88 } }
box { <2.5, -0.2, -7>, <2.6, 4.1, 9> pigment { rgb <0.02, 0.03, 0.03> }
    finish { ambient 0 diffuse 0.3 reflection 0.88 } }

// The figure in the middle: a pedestal, a ball of glass, gilt cones.
cylinder { <0.35, 0, 0.6>, <0.35, 0.16, 0.6>, 0.62 pigment { rgb <0.14, 0.16, 0.2> }
    finish { reflection 0.15 phong 0.4 } }
cone { <0.35, 0.16, 0.6>, 0.44, <0.35, 0.95, 0.6>, 0.24 pigment { rgb <0.75, 0.72, 0.68> }
    finish { phong 0.3 } }
cylinder { <0.35, 0.95, 0.6>, <0.35, 1.03, 0.6>, 0.4 pigment { rgb <0.85, 0.6, 0.25> }
    finish { reflection 0.25 phong 0.8 metallic } }
sphere { <0.35, 1.45, 0.6>, 0.42 pigment { rgbf <0.82, 0.95, 1, 0.92> } interior { ior 1.5 }
    finish { ambient 0 diffuse 0.05 reflection 0.12 phong 1 phong_size 150 } }
cone { <0.35, 1.85, 0.6>, 0.16, <0.35, 2.5, 0.6>, 0 pigment { rgb <0.85, 0.6, 0.25> }
    finish { reflection 0.25 phong 0.8 metallic } }
sphere { <1.5, 0.33, -0.9>, 0.33 pigment { rgb <0.62, 0.06, 0.05> }
    finish { reflection 0.14 phong 0.8 phong_size 70 } }
sphere { <1.15, 0.22, -1.5>, 0.22 pigment { rgb <0.05, 0.2, 0.5> }
    finish { reflection 0.14 phong 0.8 phong_size 70 } }
// Floor, lamps, pillars and frames.
box { <-2.5, -0.2, -7>, <-1.5, 0, -6> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, -7>, <-0.5, 0, -6> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, -7>, <0.5, 0, -6> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, -7>, <1.5, 0, -6> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, -7>, <2.5, 0, -6> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, -6>, <-1.5, 0, -5> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, -6>, <-0.5, 0, -5> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, -6>, <0.5, 0, -5> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, -6>, <1.5, 0, -5> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, -6>, <2.5, 0, -5> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-2.5, -0.2, -5>, <-1.5, 0, -4> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, -5>, <-0.5, 0, -4> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, -5>, <0.5, 0, -4> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, -5>, <1.5, 0, -4> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, -5>, <2.5, 0, -4> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, -4>, <-1.5, 0, -3> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, -4>, <-0.5, 0, -3> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, -4>, <0.5, 0, -3> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, -4>, <1.5, 0, -3> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, -4>, <2.5, 0, -3> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-2.5, -0.2, -3>, <-1.5, 0, -2> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, -3>, <-0.5, 0, -2> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, -3>, <0.5, 0, -2> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, -3>, <1.5, 0, -2> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, -3>, <2.5, 0, -2> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, -2>, <-1.5, 0, -1> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, -2>, <-0.5, 0, -1> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, -2>, <0.5, 0, -1> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, -2>, <1.5, 0, -1> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, -2>, <2.5, 0, -1> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-2.5, -0.2, -1>, <-1.5, 0, 0> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, -1>, <-0.5, 0, 0> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, -1>, <0.5, 0, 0> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, -1>, <1.5, 0, 0> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, -1>, <2.5, 0, 0> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 0>, <-1.5, 0, 1> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 0>, <-0.5, 0, 1> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 0>, <0.5, 0, 1> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, 0>, <1.5, 0, 1> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, 0>, <2.5, 0, 1> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 1>, <-1.5, 0, 2> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 1>, <-0.5, 0, 2> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 1>, <0.5, 0, 2> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, 1>, <1.5, 0, 2> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, 1>, <2.5, 0, 2> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 2>, <-1.5, 0, 3> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 2>, <-0.5, 0, 3> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 2>, <0.5, 0, 3> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, 2>, <1.5, 0, 3> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, 2>, <2.5, 0, 3> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 3>, <-1.5, 0, 4> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 3>, <-0.5, 0, 4> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 3>, <0.5, 0, 4> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, 3>, <1.5, 0, 4> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, 3>, <2.5, 0, 4> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 4>, <-1.5, 0, 5> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 4>, <-0.5, 0, 5> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 4>, <0.5, 0, 5> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, 4>, <1.5, 0, 5> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, 4>, <2.5, 0, 5> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 5>, <-1.5, 0, 6> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 5>, <-0.5, 0, 6> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 5>, <0.5, 0, 6> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, 5>, <1.5, 0, 6> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, 5>, <2.5, 0, 6> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 6>, <-1.5, 0, 7> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 6>, <-0.5, 0, 7> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 6>, <0.5, 0, 7> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, 6>, <1.5, 0, 7> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, 6>, <2.5, 0, 7> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 7>, <-1.5, 0, 8> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 7>, <-0.5, 0, 8> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 7>, <0.5, 0, 8> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <0.5, -0.2, 7>, <1.5, 0, 8> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <1.5, -0.2, 7>, <2.5, 0, 8> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-2.5, -0.2, 8>, <-1.5, 0, 9> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <-1.5, -0.2, 8>, <-0.5, 0, 9> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <-0.5, -0.2, 8>, <0.5, 0, 9> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
box { <0.5, -0.2, 8>, <1.5, 0, 9> pigment { rgb <0.72, 0.68, 0.6> } finish { reflection 0.12 } }
box { <1.5, -0.2, 8>, <2.5, 0, 9> pigment { rgb <0.05, 0.06, 0.09> } finish { reflection 0.12 } }
cylinder { <0, 3.55, -3.5>, <0, 4, -3.5>, 0.02 pigment { rgb <0.85, 0.6, 0.25> } no_shadow }
sphere { <0, 3.3, -3.5>, 0.26 pigment { rgb <1, 0.86, 0.62> } finish { ambient 1 diffuse 0 } no_shadow }
cylinder { <0, 3.55, -1>, <0, 4, -1>, 0.02 pigment { rgb <0.85, 0.6, 0.25> } no_shadow }
sphere { <0, 3.3, -1>, 0.26 pigment { rgb <1, 0.86, 0.62> } finish { ambient 1 diffuse 0 } no_shadow }
cylinder { <0, 3.55, 1.5>, <0, 4, 1.5>, 0.02 pigment { rgb <0.85, 0.6, 0.25> } no_shadow }
sphere { <0, 3.3, 1.5>, 0.26 pigment { rgb <1, 0.86, 0.62> } finish { ambient 1 diffuse 0 } no_shadow }
cylinder { <0, 3.55, 4>, <0, 4, 4>, 0.02 pigment { rgb <0.85, 0.6, 0.25> } no_shadow }
sphere { <0, 3.3, 4>, 0.26 pigment { rgb <1, 0.86, 0.62> } finish { ambient 1 diffuse 0 } no_shadow }
cylinder { <0, 3.55, 6.5>, <0, 4, 6.5>, 0.02 pigment { rgb <0.85, 0.6, 0.25> } no_shadow }
sphere { <0, 3.3, 6.5>, 0.26 pigment { rgb <1, 0.86, 0.62> } finish { ambient 1 diffuse 0 } no_shadow }
cylinder { <-2.42, 0.2, -5.75>, <-2.42, 3.7, -5.75>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <-2.42, 3.6, -5.75>, 0.09, <-2.42, 4, -5.75>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <-2.42, 0, -5.75>, 0.22, <-2.42, 0.3, -5.75>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cylinder { <-2.42, 0.2, -2.25>, <-2.42, 3.7, -2.25>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <-2.42, 3.6, -2.25>, 0.09, <-2.42, 4, -2.25>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <-2.42, 0, -2.25>, 0.22, <-2.42, 0.3, -2.25>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cylinder { <-2.42, 0.2, 1.25>, <-2.42, 3.7, 1.25>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <-2.42, 3.6, 1.25>, 0.09, <-2.42, 4, 1.25>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <-2.42, 0, 1.25>, 0.22, <-2.42, 0.3, 1.25>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cylinder { <-2.42, 0.2, 4.75>, <-2.42, 3.7, 4.75>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <-2.42, 3.6, 4.75>, 0.09, <-2.42, 4, 4.75>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <-2.42, 0, 4.75>, 0.22, <-2.42, 0.3, 4.75>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
box { <-2.48, 0, -7>, <-2.36, 0.14, 9> pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
box { <-2.48, 3.86, -7>, <-2.36, 4, 9> pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cylinder { <2.42, 0.2, -5.75>, <2.42, 3.7, -5.75>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <2.42, 3.6, -5.75>, 0.09, <2.42, 4, -5.75>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <2.42, 0, -5.75>, 0.22, <2.42, 0.3, -5.75>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cylinder { <2.42, 0.2, -2.25>, <2.42, 3.7, -2.25>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <2.42, 3.6, -2.25>, 0.09, <2.42, 4, -2.25>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <2.42, 0, -2.25>, 0.22, <2.42, 0.3, -2.25>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cylinder { <2.42, 0.2, 1.25>, <2.42, 3.7, 1.25>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <2.42, 3.6, 1.25>, 0.09, <2.42, 4, 1.25>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <2.42, 0, 1.25>, 0.22, <2.42, 0.3, 1.25>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cylinder { <2.42, 0.2, 4.75>, <2.42, 3.7, 4.75>, 0.09 pigment { rgb <0.82, 0.78, 0.7> } }
cone { <2.42, 3.6, 4.75>, 0.09, <2.42, 4, 4.75>, 0.26 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
cone { <2.42, 0, 4.75>, 0.22, <2.42, 0.3, 4.75>, 0.09 pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
box { <2.36, 0, -7>, <2.48, 0.14, 9> pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
box { <2.36, 3.86, -7>, <2.48, 4, 9> pigment { rgb <0.85, 0.6, 0.25> } finish { reflection 0.2 phong 0.7 metallic } }
