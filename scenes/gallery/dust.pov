// Light in dust: sun through the slats of a shutter, a lamp on the floor whose cone is seen, and a column of smoke.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <-0.9, 1.6, -5.6> look_at <0.4, 1.4, 0> angle 66 }

// The room; the right wall has a window.
#declare Plaster = texture { pigment { rgb <0.55, 0.5, 0.44> } finish { ambient 0.03 diffuse 0.6 } }
box { <-4, -0.2, -9>, <4, 0, 4> hollow texture { pigment { wood scale 0.35 rotate 90*y color_map { [0 rgb <0.34, 0.22, 0.13>] [1 rgb <0.22, 0.13, 0.07>] } }
    finish { ambient 0.03 diffuse 0.6 reflection 0.04 } } }
box { <-4, 3.4, -9>, <4, 3.6, 4> hollow texture { Plaster } }
box { <-4.2, 0, -9>, <-4, 3.4, 4> hollow texture { Plaster } }
box { <-4, 0, 4>, <4, 3.4, 4.2> hollow texture { Plaster } }
box { <-4, 0, -9.2>, <4, 3.4, -9> hollow texture { Plaster } }
difference {
    box { <4, 0, -9>, <4.2, 3.4, 4> }
    box { <3.9, 1.3, -0.6>, <4.3, 3, 1.6> }
    hollow texture { Plaster }
}
#declare I = 0;
#while (I < 5)
    box { <-0.01, -0.11, -1.12>, <0.01, 0.11, 1.12> rotate 20*z translate <4.1, 1.45 + 0.36*I, 0.5>
        pigment { rgb <0.35, 0.24, 0.16> } finish { ambient 0.03 diffuse 0.6 } }
    #declare I = I + 1;
#end

light_source { <260, 150, -20> rgb <9, 7.2, 5> parallel point_at <4, 2.15, 0.5> }
light_source { <-3.1, 0.25, 1.8> rgb <2.2, 2.7, 4> spotlight point_at <-2.2, 3.4, 2.6> radius 13 falloff 19 fade_distance 2 fade_power 2 }
light_source { <0, 3.2, -6> rgb <0.45, 0.47, 0.55> media_interaction off fade_distance 4 fade_power 1 }

cylinder { <-3.1, 0, 1.8>, <-3.1, 0.2, 1.8>, 0.16 pigment { rgb 0.1 } finish { ambient 0.02 diffuse 0.5 phong 0.4 } }
sphere { <-0.6, 0.55, 1.1>, 0.55 pigment { rgb <0.75, 0.2, 0.13> } finish { ambient 0.03 diffuse 0.6 phong 0.5 phong_size 60 } }
box { <-0.5, 0, -0.5>, <0.5, 1, 0.5> rotate 31*y translate <1.25, 0, 1.4> pigment { rgb <0.24, 0.34, 0.55> } finish { ambient 0.03 diffuse 0.6 } }
sphere { <1.25, 1.38, 1.4>, 0.38 pigment { rgbt <0.95, 1, 0.97, 0.92> } interior { ior 1.5 } finish { ambient 0 diffuse 0.03 reflection { 0.02, 0.7 fresnel } phong 0.9 phong_size 200 } }
cylinder { <2.2, 0, -0.1>, <2.2, 0.32, -0.1>, 0.3 pigment { rgb <0.4, 0.27, 0.1> } finish { ambient 0.03 diffuse 0.5 phong 0.5 } }

// Dust in the air, and smoke above the bowl.
media { scattering { 5, rgb 0.06 eccentricity 0.25 } samples 64 }
cylinder { <0, 0, 0>, <0, 1, 0>, 1 hollow pigment { rgbt 1 } finish { ambient 0 diffuse 0 }
    interior { media { scattering { 1, rgb <2.4, 2.5, 2.7> extinction 1 } absorption 0.2
        density { cylindrical warp { turbulence <0.5, 0.7, 0.5> octaves 4 } color_map { [0.25 rgb 0] [0.6 rgb 0.5] [1 rgb 1.6] } }
        density { gradient y color_map { [0 rgb 1] [0.75 rgb 0.5] [1 rgb 0] } } } }
    scale <0.55, 2.4, 0.55> translate <2.2, 0.3, -0.1> }
