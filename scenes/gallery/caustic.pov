// Light that glass gathers: a ball and a bowl, a polished ring of brass, and a prism that spreads the colours.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 photons { spacing 0.01 } }
camera { location <0.3, 4.3, -6> look_at <0.1, 0.25, 0.1> angle 45 }
light_source { <-6, 6.5, 4.5> rgb 1.7 spotlight point_at 0 radius 22 falloff 34 }

plane { y, 0 pigment { rgb <0.86, 0.8, 0.7> } finish { ambient 0.03 diffuse 0.6 } }
#declare Clear = finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel } conserve_energy phong 0.6 phong_size 300 }

sphere { <-1.7, 0.75, 0.4>, 0.75 pigment { rgbf <0.96, 1, 0.98, 0.97> } finish { Clear } interior { ior 1.5 }
    photons { target refraction on reflection off } }
difference {
    cylinder { <0, 0, 0>, <0, 0.7, 0>, 0.62 }
    sphere { <0, 0.82, 0>, 0.58 }
    pigment { rgbf <0.55, 0.8, 1, 0.97> } finish { Clear } interior { ior 1.5 }
    photons { target refraction on reflection off } translate <0.2, 0.001, -0.6>
}
difference {
    cylinder { <0, 0.001, 0>, <0, 0.3, 0>, 0.8 }
    cylinder { <0, -1, 0>, <0, 1, 0>, 0.76 }
    pigment { rgb <0.75, 0.55, 0.25> } finish { ambient 0 diffuse 0.1 reflection <0.85, 0.66, 0.33> metallic }
    photons { target reflection on refraction off } translate <2.05, 0, -0.1>
}
prism { linear_sweep 0, 1.3, 4, <-0.36, -0.21>, <0.36, -0.21>, <0, 0.42>, <-0.36, -0.21>
    pigment { rgbf 0.98 } finish { Clear } interior { ior 1.55 dispersion 1.12 dispersion_samples 12 }
    photons { target refraction on reflection off } rotate 40*y translate <-0.2, 0.001, 1.4> }
