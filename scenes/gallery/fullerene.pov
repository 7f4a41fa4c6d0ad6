// Buckminsterfullerene: sixty atoms and ninety bonds around a ball of blue glass, through which its far
// side is seen bent.
global_settings { assumed_gamma 1 max_trace_level 10 ambient_light rgb <0.6, 0.8, 1> }
camera { location <2, 3.2, -23.5> look_at <-0.1, -0.45, 0> angle 41 }
light_source { <-4200, 4600, -3900> rgb <1.45, 1.3, 1.12> }
light_source { <1500, 500, 2430> rgb <1.6, 3.0, 3.4> }
sphere { 0, 3000 no_shadow pigment { rgb 1 } finish { ambient rgb <0.008, 0.018, 0.028> diffuse 0.07 } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 5.6 pigment { rgb <0.05, 0.065, 0.075> }
    finish { reflection 0.3 } }
sphere { <0, 0, 0>, 2.9 pigment { rgbf <0.35, 0.72, 1, 0.93> } interior { ior 1.45 }
    finish { ambient 0 diffuse 0.1 reflection 0.14 phong 0.9 phong_size 160 } }
// Beside it: water and methane.
sphere { <5.9, -4.35, -4.6>, 1 pigment { rgb <0.75, 0.05, 0.04> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
sphere { <6.8177, -4.6368, -3.9691>, 0.62 pigment { rgb <0.85, 0.85, 0.82> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
sphere { <5.1984, -4.5763, -3.7174>, 0.62 pigment { rgb <0.85, 0.85, 0.82> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
sphere { <-6.5, -4.25, -3.2>, 1.1 pigment { rgb <0.13, 0.13, 0.15> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
sphere { <-5.3741, -4.6879, -3.5753>, 0.66 pigment { rgb <0.85, 0.85, 0.82> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
sphere { <-7.1286, -4.69, -4.2057>, 0.66 pigment { rgb <0.85, 0.85, 0.82> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
sphere { <-7.0047, -4.6916, -2.1274>, 0.66 pigment { rgb <0.85, 0.85, 0.82> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
sphere { <-6.5, -2.985, -3.2>, 0.66 pigment { rgb <0.85, 0.85, 0.82> } finish { phong 0.7 phong_size 50 reflection 0.05 } }
cylinder { <-4.8541, 0, -1>, <-4.8541, 0, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.8541, 0, -1>, <-4.2361, -1.618, -2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.8541, 0, -1>, <-4.2361, 1.618, -2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.8541, 0, 1>, <-4.2361, -1.618, 2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.8541, 0, 1>, <-4.2361, 1.618, 2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, -1.618, -2>, <-3.618, -3.2361, -1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, -1.618, -2>, <-3.2361, -1, -3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, -1.618, 2>, <-3.618, -3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, -1.618, 2>, <-3.2361, -1, 3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, 1.618, -2>, <-3.618, 3.2361, -1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, 1.618, -2>, <-3.2361, 1, -3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, 1.618, 2>, <-3.618, 3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-4.2361, 1.618, 2>, <-3.2361, 1, 3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.618, -3.2361, -1>, <-3.618, -3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.618, -3.2361, -1>, <-2, -4.2361, -1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.618, -3.2361, 1>, <-2, -4.2361, 1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.618, 3.2361, -1>, <-3.618, 3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.618, 3.2361, -1>, <-2, 4.2361, -1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.618, 3.2361, 1>, <-2, 4.2361, 1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.2361, -1, -3.618>, <-3.2361, 1, -3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.2361, -1, -3.618>, <-1.618, -2, -4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.2361, -1, 3.618>, <-3.2361, 1, 3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.2361, -1, 3.618>, <-1.618, -2, 4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.2361, 1, -3.618>, <-1.618, 2, -4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-3.2361, 1, 3.618>, <-1.618, 2, 4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, -4.2361, -1.618>, <-1, -4.8541, 0>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, -4.2361, -1.618>, <-1, -3.618, -3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, -4.2361, 1.618>, <-1, -4.8541, 0>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, -4.2361, 1.618>, <-1, -3.618, 3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, 4.2361, -1.618>, <-1, 3.618, -3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, 4.2361, -1.618>, <-1, 4.8541, 0>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, 4.2361, 1.618>, <-1, 3.618, 3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-2, 4.2361, 1.618>, <-1, 4.8541, 0>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, -2, -4.2361>, <-1, -3.618, -3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, -2, -4.2361>, <0, -1, -4.8541>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, -2, 4.2361>, <-1, -3.618, 3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, -2, 4.2361>, <0, -1, 4.8541>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, 2, -4.2361>, <-1, 3.618, -3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, 2, -4.2361>, <0, 1, -4.8541>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, 2, 4.2361>, <-1, 3.618, 3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1.618, 2, 4.2361>, <0, 1, 4.8541>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1, -4.8541, 0>, <1, -4.8541, 0>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1, -3.618, -3.2361>, <1, -3.618, -3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1, -3.618, 3.2361>, <1, -3.618, 3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1, 3.618, -3.2361>, <1, 3.618, -3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1, 3.618, 3.2361>, <1, 3.618, 3.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <-1, 4.8541, 0>, <1, 4.8541, 0>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <0, -1, -4.8541>, <0, 1, -4.8541>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <0, -1, -4.8541>, <1.618, -2, -4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <0, -1, 4.8541>, <0, 1, 4.8541>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <0, -1, 4.8541>, <1.618, -2, 4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <0, 1, -4.8541>, <1.618, 2, -4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <0, 1, 4.8541>, <1.618, 2, 4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, -4.8541, 0>, <2, -4.2361, -1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, -4.8541, 0>, <2, -4.2361, 1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, -3.618, -3.2361>, <1.618, -2, -4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, -3.618, -3.2361>, <2, -4.2361, -1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, -3.618, 3.2361>, <1.618, -2, 4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, -3.618, 3.2361>, <2, -4.2361, 1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, 3.618, -3.2361>, <1.618, 2, -4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, 3.618, -3.2361>, <2, 4.2361, -1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, 3.618, 3.2361>, <1.618, 2, 4.2361>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, 3.618, 3.2361>, <2, 4.2361, 1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, 4.8541, 0>, <2, 4.2361, -1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1, 4.8541, 0>, <2, 4.2361, 1.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1.618, -2, -4.2361>, <3.2361, -1, -3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1.618, -2, 4.2361>, <3.2361, -1, 3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1.618, 2, -4.2361>, <3.2361, 1, -3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <1.618, 2, 4.2361>, <3.2361, 1, 3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <2, -4.2361, -1.618>, <3.618, -3.2361, -1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <2, -4.2361, 1.618>, <3.618, -3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <2, 4.2361, -1.618>, <3.618, 3.2361, -1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <2, 4.2361, 1.618>, <3.618, 3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.2361, -1, -3.618>, <3.2361, 1, -3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.2361, -1, -3.618>, <4.2361, -1.618, -2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.2361, -1, 3.618>, <3.2361, 1, 3.618>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.2361, -1, 3.618>, <4.2361, -1.618, 2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.2361, 1, -3.618>, <4.2361, 1.618, -2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.2361, 1, 3.618>, <4.2361, 1.618, 2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.618, -3.2361, -1>, <3.618, -3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.618, -3.2361, -1>, <4.2361, -1.618, -2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.618, -3.2361, 1>, <4.2361, -1.618, 2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.618, 3.2361, -1>, <3.618, 3.2361, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.618, 3.2361, -1>, <4.2361, 1.618, -2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <3.618, 3.2361, 1>, <4.2361, 1.618, 2>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <4.2361, -1.618, -2>, <4.8541, 0, -1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <4.2361, -1.618, 2>, <4.8541, 0, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <4.2361, 1.618, -2>, <4.8541, 0, -1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <4.2361, 1.618, 2>, <4.8541, 0, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
cylinder { <4.8541, 0, -1>, <4.8541, 0, 1>, 0.17 rotate <12, 23, 8> pigment { rgb <0.55, 0.6, 0.64> } finish { phong 0.5 reflection 0.12 } }
sphere { <-4.8541, 0, -1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-4.8541, 0, 1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-4.2361, -1.618, -2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-4.2361, -1.618, 2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-4.2361, 1.618, -2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-4.2361, 1.618, 2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.618, -3.2361, -1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.618, -3.2361, 1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.618, 3.2361, -1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.618, 3.2361, 1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.2361, -1, -3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.2361, -1, 3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.2361, 1, -3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-3.2361, 1, 3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-2, -4.2361, -1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-2, -4.2361, 1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-2, 4.2361, -1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-2, 4.2361, 1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1.618, -2, -4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1.618, -2, 4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1.618, 2, -4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1.618, 2, 4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1, -4.8541, 0>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1, -3.618, -3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1, -3.618, 3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1, 3.618, -3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1, 3.618, 3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <-1, 4.8541, 0>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <0, -1, -4.8541>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <0, -1, 4.8541>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <0, 1, -4.8541>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <0, 1, 4.8541>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1, -4.8541, 0>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1, -3.618, -3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1, -3.618, 3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1, 3.618, -3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1, 3.618, 3.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1, 4.8541, 0>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1.618, -2, -4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1.618, -2, 4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1.618, 2, -4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <1.618, 2, 4.2361>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <2, -4.2361, -1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <2, -4.2361, 1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <2, 4.2361, -1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <2, 4.2361, 1.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.2361, -1, -3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.2361, -1, 3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.2361, 1, -3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.2361, 1, 3.618>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.618, -3.2361, -1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.618, -3.2361, 1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.618, 3.2361, -1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <3.618, 3.2361, 1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <4.2361, -1.618, -2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <4.2361, -1.618, 2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <4.2361, 1.618, -2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <4.2361, 1.618, 2>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <4.8541, 0, -1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
sphere { <4.8541, 0, 1>, 0.5 rotate <12, 23, 8> pigment { rgb <0.8, 0.4, 0.12> } finish { phong 0.8 phong_size 60 reflection 0.12 } }
