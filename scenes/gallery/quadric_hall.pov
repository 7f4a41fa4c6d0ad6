// A hall of hyperboloids: each column flares into the vault and into the floor, which mirrors it. The far
// light is warm, the near one cool; an ellipsoid of brass floats between them.
global_settings { assumed_gamma 1 max_trace_level 8 ambient_light rgb <0.5, 0.6, 0.9> }
camera { location <0.75, 1.45, -15.2> look_at <-0.2, 2.05, 0> angle 50 }
light_source { <2, 1.7, 21> rgb <1.5, 0.85, 0.42> }
light_source { <0.6, 3.2, 6> rgb <0.55, 0.36, 0.2> }
light_source { <-0.6, 3.2, -6> rgb <0.34, 0.24, 0.15> }
light_source { <3.4, 2.2, -17> rgb <0.10, 0.24, 0.46> }

quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 0 pigment { rgb <0.10, 0.13, 0.17> } finish { reflection 0.42 } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, -1, 0>, 4.2 pigment { rgb <0.72, 0.66, 0.58> } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 0, -1>, 30 pigment { rgb <0.9, 0.6, 0.35> } finish { ambient 0.5 } }
quadric { <3.2, 1.6, 3.2>, <0.4, 0, 0.3>, <0, 0, 0>, -1 translate <0, 1.9, -2>
    pigment { rgb <0.75, 0.5, 0.18> } finish { reflection 0.45 phong 0.8 phong_size 60 metallic } }
quadric { <16, 16, 16>, <0, 0, 0>, <0, 0, 0>, -1 translate <-0.6, 3.2, -6> no_shadow
    pigment { rgb <1, 0.85, 0.6> } finish { ambient 3 diffuse 0 } }
// The columns.
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, -8> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, -8> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, -8> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, -8> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, -8> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, -8> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, -4> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, -4> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, -4> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, -4> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, -4> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, -4> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, 0> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, 0> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, 0> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, 0> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, 0> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, 0> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, 4> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, 4> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, 4> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, 4> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, 4> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, 4> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, 8> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, 8> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, 8> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, 8> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, 8> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, 8> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, 12> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, 12> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, 12> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, 12> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, 12> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, 12> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, 16> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, 16> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, 16> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, 16> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, 16> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, 16> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, 20> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, 20> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, 20> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, 20> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, 20> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, 20> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-10, 2.1, 24> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-6, 2.1, 24> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <-2, 2.1, 24> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <2, 2.1, 24> pigment { rgb <0.62, 0.64, 0.68> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <6, 2.1, 24> pigment { rgb <0.74, 0.68, 0.6> } }
quadric { <1, -0.22, 1>, <0, 0, 0>, <0, 0, 0>, -0.06 translate <10, 2.1, 24> pigment { rgb <0.62, 0.64, 0.68> } }
