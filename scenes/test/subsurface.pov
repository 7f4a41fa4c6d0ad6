// Wax and marble: light that is scattered below the surface, of a sphere, of a thin plate lit from behind, and without.
#version 3.7;
global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 100, 100 } }
camera { location <0, 1.5, -5> look_at <0, 0.4, 0> angle 45 }
light_source { <3, 5, 4> rgb 1 }
light_source { <-4, 4, -3> rgb 0.3 }
plane { y, -0.6 pigment { rgb 0.5 } finish { ambient 0 diffuse 0.6 } }
sphere { <-1.1, 0.4, 0>, 0.9 pigment { rgb <0.9, 0.7, 0.4> } interior { ior 1.3 }
         finish { ambient 0 diffuse 0.9 phong 0.3 subsurface { translucency <3, 1.5, 0.7> } } }
box { <0.2, -0.6, 0>, <1, 1.3, 0.12> pigment { rgb 0.9 } interior { ior 1.4 } finish { ambient 0 diffuse 0.9 subsurface { translucency 2 } } }
box { <1.2, -0.6, 0>, <2, 1.3, 0.12> pigment { rgb 0.9 } finish { ambient 0 diffuse 0.9 } }
