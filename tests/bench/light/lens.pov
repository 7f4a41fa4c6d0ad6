// 25 spheres on a floor through a lens that is sharp on the middle one. POV-Ray's settings: Blur, Least (variance).
#version 3.7;
#ifndef (Blur) #declare Blur = 40; #end
#ifndef (Least) #declare Least = 0; #end
global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <0.4, 0.5, 0.7> }
camera { location <2, 3, -5.5> look_at <0, 0.2, 0> angle 42 aperture 0.2 focal_point <0, 0.45, 0> blur_samples Blur variance Least confidence 0.95 }
light_source { <6, 10, -8> rgb 0.8 }
light_source { <-7, 6, -4> rgb 0.3 }
#default { pigment { rgb <0.8, 0.5, 0.3> } finish { phong 0.4 ambient 0.05 } }
box { <-8, -0.1, -8>, <8, 0, 8> }
#for (I, -2, 2) #for (K, -2, 2) sphere { <I, 0.45, K>, 0.45 } #end #end
