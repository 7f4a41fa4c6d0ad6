// Glass that is a target of photons: a coloured ball, and a thick plate with a pane before it that lets photons pass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 photons { spacing 0.01 autostop 0 } }
camera { location <0, 4, -6> look_at <0, 0, 0.3> angle 45 }
light_source { <4, 7, 3> rgb 1 }
plane { y, 0 pigment { rgb <0.8, 0.8, 0.75> } finish { ambient 0 diffuse 0.8 phong 0.2 } }
sphere { <-0.9, 1, 0.3>, 0.8 pigment { rgbf <0.9, 0.6, 0.5, 0.9> } finish { ambient 0 diffuse 0.05 reflection { 0, 1 fresnel } conserve_energy }
         interior { ior 1.5 } photons { target refraction on reflection on } }
difference {
    box { <0.6, 0.05, -0.8>, <2, 1.2, 0.4> }
    sphere { <1.3, 1.8, -0.2>, 0.9 }
    pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 fade_distance 2 fade_power 1001 fade_color <0.2, 0.7, 0.5> }
    photons { target refraction on collect off }
}
box { <1.2, 1.6, 0.2>, <2.6, 1.62, 1.4> pigment { rgbt <1, 1, 1, 0.8> } finish { ambient 0 diffuse 0 } photons { pass_through } }
