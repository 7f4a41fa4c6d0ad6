// A spotlight in fog, and 300 small spheres that shade it. POV-Ray's settings: Method, Samples.
#version 3.7;
#ifndef (Method) #declare Method = 2; #end
#ifndef (Samples) #declare Samples = 6; #end
global_settings { assumed_gamma 1 max_trace_level 5 }
camera { location <0, 1.5, -8> look_at <0, 1.5, 0> angle 50 }
light_source { <-3, 5, 2> rgb 1.6 spotlight point_at <0.5, 0, 0> radius 16 falloff 24 }
#default { finish { ambient 0.02 diffuse 0.7 } }
plane { y, 0 pigment { rgb <0.5, 0.52, 0.55> } }
plane { -z, -6 pigment { rgb <0.4, 0.45, 0.5> } }
#declare R = seed(7);
#declare I = 0;
#while (I < 300)
    sphere { <-3 + 6*rand(R), 4*rand(R), -2.5 + 5*rand(R)>, 0.03 + 0.07*rand(R) pigment { rgb <0.8, 0.6, 0.4> } }
    #declare I = I + 1;
#end
media { scattering { 1, 0.04 extinction 1 } method Method intervals 1 samples Samples, Samples }
