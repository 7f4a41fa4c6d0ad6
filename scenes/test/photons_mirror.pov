// A ring that mirrors light of a spotlight onto the floor, and a mirror that takes no part.
#version 3.7;
global_settings { assumed_gamma 1 photons { count 40000 } }
camera { location <0, 5, -5> look_at <0, 0, 0> angle 45 }
light_source { <-4, 3, -1> rgb 1 spotlight point_at <0.5, 0, 0.2> radius 20 falloff 28 fade_distance 6 fade_power 2 }
plane { y, 0 pigment { checker rgb 0.9 rgb 0.6 } finish { ambient 0.05 diffuse 0.7 } }
cylinder { 0, 0.8*y, 1.3 open pigment { rgb <0.8, 0.7, 0.3> } finish { ambient 0 diffuse 0.2 reflection { 0.8 metallic } }
           photons { target reflection on collect off } }
box { <1.6, 0, 0.8>, <1.7, 1.2, 2> pigment { rgb 0.2 } finish { ambient 0 diffuse 0.3 reflection 0.5 } }
