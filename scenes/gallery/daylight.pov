// A room by daylight: the sun through a window and the sky's light, and what floor and walls send on. Nothing else shines.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 radiosity { recursion_limit 4 count 16 } }
camera { location <1.9, 1.55, -4.3> look_at <-0.35, 1.15, 0> angle 62 }

#declare Wall = texture { pigment { rgb <0.78, 0.74, 0.66> } finish { diffuse 0.8 } }
#declare Oak = texture { pigment { wood turbulence 0.04 scale 0.11 rotate <2, 86, 0> color_map { [0 rgb <0.5, 0.32, 0.18>] [1 rgb <0.36, 0.21, 0.11>] } } finish { diffuse 0.75 } }

// Floor of boards, walls, ceiling; the left wall has a window.
#declare I = 0;
#while (I < 10)
    box { <-2.5 + 0.5*I, -0.1, -5>, <-2.01 + 0.5*I, 0, 2.5> texture { Oak translate <0.7*I, 3*I, I> } }
    #declare I = I + 1;
#end
box { <-2.5, -0.2, -5>, <2.5, -0.005, 2.5> pigment { rgb <0.1, 0.06, 0.04> } }
box { <-2.5, 2.7, -5>, <2.5, 2.8, 2.5> pigment { rgb 0.85 } finish { diffuse 0.85 } }
box { <-2.5, 0, 2.5>, <2.5, 2.7, 2.6> texture { Wall } }
box { <-2.5, 0, -5.1>, <2.5, 2.7, -5> texture { Wall } }
box { <2.5, 0, -5>, <2.6, 2.7, 2.5> pigment { rgb <0.55, 0.28, 0.2> } finish { diffuse 0.8 } }
difference {
    box { <-2.8, 0, -5>, <-2.5, 2.7, 2.5> }
    box { <-3, 0.8, -1.3>, <-2.4, 2.3, 1.1> }
    texture { Wall }
}
// The frame, and the sky before the window.
union {
    box { <-2.68, 0.8, -0.13>, <-2.62, 2.3, -0.07> }
    box { <-2.68, 1.75, -1.3>, <-2.62, 1.81, 1.1> }
    box { <-2.75, 0.76, -1.4>, <-2.38, 0.8, 1.2> }
    pigment { rgb 0.9 } finish { diffuse 0.8 }
}
polygon { 5, <0.8, -1.3>, <2.3, -1.3>, <2.3, 1.1>, <0.8, 1.1>, <0.8, -1.3>
    matrix <0, 1, 0, 0, 0, 1, 1, 0, 0, -2.79, 0, 0> no_shadow pigment { rgb <0.62, 0.8, 1> } finish { diffuse 0 emission 9 } }
light_source { <-40, 34, -9> rgb <19, 16, 12> parallel point_at <-2.6, 1.6, -0.1> }

// A table with a bowl of fruit, a chair, a picture, a rug.
union {
    box { <-0.85, 0.7, -0.5>, <0.85, 0.75, 0.5> }
    box { <-0.8, 0, -0.45>, <-0.73, 0.7, -0.38> } box { <0.73, 0, -0.45>, <0.8, 0.7, -0.38> }
    box { <-0.8, 0, 0.38>, <-0.73, 0.7, 0.45> } box { <0.73, 0, 0.38>, <0.8, 0.7, 0.45> }
    texture { Oak } rotate 12*y translate <-0.25, 0, 0.55>
}
difference {
    sphere { 0, 0.24 } sphere { 0, 0.225 } box { <-1, 0, -1>, 1 }
    pigment { rgb <0.85, 0.87, 0.9> } finish { diffuse 0.75 phong 0.3 } translate <-0.3, 0.99, 0.5>
}
sphere { <-0.37, 0.93, 0.45>, 0.09 pigment { rgb <0.75, 0.3, 0.05> } finish { diffuse 0.75 } }
sphere { <-0.2, 0.94, 0.5>, 0.09 pigment { rgb <0.7, 0.12, 0.06> } finish { diffuse 0.75 } }
sphere { <-0.32, 0.97, 0.6>, 0.085 pigment { rgb <0.45, 0.55, 0.1> } finish { diffuse 0.75 } }
cylinder { <0.3, 0.75, 0.62>, <0.3, 1.02, 0.62>, 0.06 pigment { rgb <0.2, 0.35, 0.5> } finish { diffuse 0.75 reflection 0.04 phong 0.4 } }
union {
    box { <-0.24, 0.42, -0.24>, <0.24, 0.47, 0.24> } box { <-0.24, 0.47, 0.2>, <0.24, 1, 0.24> }
    box { <-0.24, 0, -0.24>, <-0.19, 0.42, -0.19> } box { <0.19, 0, -0.24>, <0.24, 0.42, -0.19> }
    box { <-0.24, 0, 0.19>, <-0.19, 0.42, 0.24> } box { <0.19, 0, 0.19>, <0.24, 0.42, 0.24> }
    pigment { rgb <0.75, 0.7, 0.6> } finish { diffuse 0.75 } rotate 200*y translate <0.5, 0, -0.6>
}
box { <-1.3, 0, -1.9>, <1.1, 0.012, 1.4> pigment { checker rgb <0.5, 0.13, 0.1>, rgb <0.6, 0.45, 0.3> scale 0.3 } finish { diffuse 0.75 } }
box { <-0.5, 1.3, 2.46>, <0.9, 2.2, 2.5> pigment { gradient y color_map { [0 rgb <0.25, 0.4, 0.2>] [0.45 rgb <0.5, 0.55, 0.3>] [0.46 rgb <0.75, 0.85, 0.95>] [1 rgb <0.3, 0.5, 0.8>] } scale 0.9 translate 1.3*y } finish { diffuse 0.75 } }
