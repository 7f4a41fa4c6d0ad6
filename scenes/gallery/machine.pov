// A machine of cylinders and cones: boiler, chimney, a piston in glass, crank, flywheel and gears.
global_settings { assumed_gamma 1 max_trace_level 7 ambient_light rgb <0.8, 0.85, 1> }
camera { location <-2.2, 3.6, -9.8> look_at <0.12, 1.5, 0> angle 42 }
light_source { <-7, 9, -8> rgb <1.4, 1.28, 1.08> }
light_source { <9, 5, -6> rgb <0.26, 0.32, 0.44> }
light_source { <-2, 7, 5> rgb <0.36, 0.28, 0.2> }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 1, 0>, 0 pigment { rgb <0.14, 0.12, 0.11> } finish { reflection 0.16 } }
quadric { <0, 0, 0>, <0, 0, 0>, <0, 0, -1>, 7 pigment { rgb <0.09, 0.13, 0.16> } }
box { <-3.9, 0.02, -1.5>, <4.1, 0.3, 1.5> pigment { rgb <0.3, 0.15, 0.07> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
box { <-3.8, 0.3, -1.4>, <4, 0.36, 1.4> pigment { rgb <0.04, 0.16, 0.1> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cylinder { <0.2, 1.25, 0.75>, <3.5, 1.25, 0.75>, 0.62 pigment { rgb <0.04, 0.16, 0.1> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cylinder { <0.25, 1.25, 0.75>, <0.35, 1.25, 0.75>, 0.65 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1.25, 1.25, 0.75>, <1.35, 1.25, 0.75>, 0.65 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.35, 1.25, 0.75>, <2.45, 1.25, 0.75>, 0.65 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <3.35, 1.25, 0.75>, <3.45, 1.25, 0.75>, 0.65 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <0.2, 1.25, 0.75>, 0.6 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <3.5, 1.25, 0.75>, 0.6 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <0.8, 0.36, 0.75>, 0.4, <0.8, 0.9, 0.75>, 0.2 pigment { rgb <0.05, 0.05, 0.06> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cone { <2.9, 0.36, 0.75>, 0.4, <2.9, 0.9, 0.75>, 0.2 pigment { rgb <0.05, 0.05, 0.06> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cone { <3, 1.75, 0.75>, 0.34, <3, 2.15, 0.75>, 0.22 pigment { rgb <0.05, 0.05, 0.06> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cylinder { <3, 2.1, 0.75>, <3, 3.7, 0.75>, 0.2 pigment { rgb <0.05, 0.05, 0.06> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cone { <3, 3.65, 0.75>, 0.2, <3, 4, 0.75>, 0.38 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1.8, 1.8, 0.75>, <1.8, 2.15, 0.75>, 0.26 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <1.8, 2.15, 0.75>, 0.26 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1, 1.8, 0.6>, <1, 2.2, 0.6>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1, 2.4, 0.55>, <1, 2.4, 0.65>, 0.24 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1, 2.4, 0.54>, <1, 2.4, 0.55>, 0.2 pigment { rgb <0.9, 0.88, 0.8> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cone { <1, 2.4, 0.525>, 0.025, <1.11, 2.52, 0.525>, 0.005 pigment { rgb <0.7, 0.05, 0.03> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cylinder { <2.2, 0.36, -0.75>, <2.2, 0.5, -0.75>, 0.52 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 0.5, -0.75>, <2.2, 1.9, -0.75>, 0.42 open pigment { rgbf <0.88, 0.97, 1, 0.9> } finish { ambient 0 diffuse 0.1 reflection 0.12 phong 0.9 phong_size 120 } }
cylinder { <2.2, 1.88, -0.75>, <2.2, 2, -0.75>, 0.52 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.654, 0.4, -0.6284>, <2.654, 2.06, -0.6284>, 0.03 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <2.654, 2.08, -0.6284>, 0.055 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.3216, 0.4, -0.296>, <2.3216, 2.06, -0.296>, 0.03 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <2.3216, 2.08, -0.296>, 0.055 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1.8677, 0.4, -0.4177>, <1.8677, 2.06, -0.4177>, 0.03 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <1.8677, 2.08, -0.4177>, 0.055 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1.746, 0.4, -0.8716>, <1.746, 2.06, -0.8716>, 0.03 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <1.746, 2.08, -0.8716>, 0.055 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.0784, 0.4, -1.204>, <2.0784, 2.06, -1.204>, 0.03 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <2.0784, 2.08, -1.204>, 0.055 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.5323, 0.4, -1.0823>, <2.5323, 2.06, -1.0823>, 0.03 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <2.5323, 2.08, -1.0823>, 0.055 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 1.05, -0.75>, <2.2, 1.35, -0.75>, 0.4 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 1.105, -0.75>, <2.2, 1.135, -0.75>, 0.412 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 1.185, -0.75>, <2.2, 1.215, -0.75>, 0.412 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 1.265, -0.75>, <2.2, 1.295, -0.75>, 0.412 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 1.35, -0.75>, <2.2, 2.55, -0.75>, 0.07 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1.8, 1.9, 0.75>, <1.8, 2.3, 0>, 0.06 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <1.8, 2.3, 0>, 0.075 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <1.8, 2.3, 0>, <2.2, 2.3, -0.2>, 0.06 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <2.2, 2.3, -0.2>, 0.075 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 2.3, -0.2>, <2.2, 1.95, -0.45>, 0.06 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <2.2, 1.95, -0.45>, 0.075 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <0.55, 0.36, -0.75>, 0.34, <0.55, 2.75, -0.75>, 0.13 pigment { rgb <0.04, 0.16, 0.1> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
sphere { <0.55, 2.86, -0.75>, 0.2 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <0.55, 2.86, -1.05>, <0.55, 2.86, -0.45>, 0.1 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <0.55, 2.86, -0.75>, 0.17, <-1.1, 3.17, -0.75>, 0.09 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.1, 3.17, -0.75>, 0.13 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.1, 3.17, -0.95>, <-1.1, 3.17, -0.55>, 0.06 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <0.55, 2.86, -0.75>, 0.17, <2.2, 2.55, -0.75>, 0.09 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <2.2, 2.55, -0.75>, 0.13 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <2.2, 2.55, -0.95>, <2.2, 2.55, -0.55>, 0.06 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.1, 3.17, -0.75>, <-1.474, 1.8483, -0.75>, 0.06 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.474, 1.8483, -0.9>, <-1.474, 1.8483, -0.45>, 0.09 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 1.55, -0.5>, 0.16, <-1.474, 1.8483, -0.5>, 0.11 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.8023, 1.7725, 0.55>, <-0.8506, 1.9415, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.8023, 1.7725, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.8506, 1.9415, 0.55>, <-0.9248, 2.1008, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.8506, 1.9415, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.9248, 2.1008, 0.55>, <-1.023, 2.2466, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.9248, 2.1008, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.023, 2.2466, 0.55>, <-1.1428, 2.3752, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.023, 2.2466, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.1428, 2.3752, 0.55>, <-1.2812, 2.4835, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.1428, 2.3752, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.2812, 2.4835, 0.55>, <-1.4348, 2.5688, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.2812, 2.4835, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.4348, 2.5688, 0.55>, <-1.5999, 2.6291, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.4348, 2.5688, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.5999, 2.6291, 0.55>, <-1.7724, 2.6627, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.5999, 2.6291, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.7724, 2.6627, 0.55>, <-1.9481, 2.669, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.7724, 2.6627, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9481, 2.669, 0.55>, <-2.1225, 2.6477, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.9481, 2.669, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.1225, 2.6477, 0.55>, <-2.2915, 2.5994, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.1225, 2.6477, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.2915, 2.5994, 0.55>, <-2.4508, 2.5252, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.2915, 2.5994, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.4508, 2.5252, 0.55>, <-2.5966, 2.427, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.4508, 2.5252, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.5966, 2.427, 0.55>, <-2.7252, 2.3072, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.5966, 2.427, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.7252, 2.3072, 0.55>, <-2.8335, 2.1688, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.7252, 2.3072, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.8335, 2.1688, 0.55>, <-2.9188, 2.0152, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.8335, 2.1688, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.9188, 2.0152, 0.55>, <-2.9791, 1.8501, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.9188, 2.0152, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.9791, 1.8501, 0.55>, <-3.0127, 1.6776, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.9791, 1.8501, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-3.0127, 1.6776, 0.55>, <-3.019, 1.5019, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-3.0127, 1.6776, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-3.019, 1.5019, 0.55>, <-2.9977, 1.3275, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-3.019, 1.5019, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.9977, 1.3275, 0.55>, <-2.9494, 1.1585, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.9977, 1.3275, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.9494, 1.1585, 0.55>, <-2.8752, 0.9992, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.9494, 1.1585, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.8752, 0.9992, 0.55>, <-2.777, 0.8534, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.8752, 0.9992, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.777, 0.8534, 0.55>, <-2.6572, 0.7248, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.777, 0.8534, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.6572, 0.7248, 0.55>, <-2.5188, 0.6165, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.6572, 0.7248, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.5188, 0.6165, 0.55>, <-2.3652, 0.5312, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.5188, 0.6165, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.3652, 0.5312, 0.55>, <-2.2001, 0.4709, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.3652, 0.5312, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.2001, 0.4709, 0.55>, <-2.0276, 0.4373, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.2001, 0.4709, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.0276, 0.4373, 0.55>, <-1.8519, 0.431, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-2.0276, 0.4373, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.8519, 0.431, 0.55>, <-1.6775, 0.4523, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.8519, 0.431, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.6775, 0.4523, 0.55>, <-1.5085, 0.5006, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.6775, 0.4523, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.5085, 0.5006, 0.55>, <-1.3492, 0.5748, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.5085, 0.5006, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.3492, 0.5748, 0.55>, <-1.2034, 0.673, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.3492, 0.5748, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.2034, 0.673, 0.55>, <-1.0748, 0.7928, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.2034, 0.673, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.0748, 0.7928, 0.55>, <-0.9665, 0.9312, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-1.0748, 0.7928, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.9665, 0.9312, 0.55>, <-0.8812, 1.0848, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.9665, 0.9312, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.8812, 1.0848, 0.55>, <-0.8209, 1.2499, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.8812, 1.0848, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.8209, 1.2499, 0.55>, <-0.7873, 1.4224, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.8209, 1.2499, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.7873, 1.4224, 0.55>, <-0.781, 1.5981, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.7873, 1.4224, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.781, 1.5981, 0.55>, <-0.8023, 1.7725, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
sphere { <-0.781, 1.5981, 0.55>, 0.09 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 1.55, 0.55>, 0.0765, <-0.8023, 1.7725, 0.55>, 0.045 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 1.55, 0.55>, 0.0765, <-1.5439, 2.6119, 0.55>, 0.045 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 1.55, 0.55>, 0.0765, <-2.6415, 2.3894, 0.55>, 0.045 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 1.55, 0.55>, 0.0765, <-2.9977, 1.3275, 0.55>, 0.045 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 1.55, 0.55>, 0.0765, <-2.2561, 0.4881, 0.55>, 0.045 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 1.55, 0.55>, 0.0765, <-1.1585, 0.7106, 0.55>, 0.045 pigment { rgb <0.5, 0.06, 0.05> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9, 1.55, 0.352>, <-1.9, 1.55, 0.748>, 0.1568 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9, 1.55, -0.55>, <-1.9, 1.55, 1.1>, 0.09 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 0.36, -0.32>, 0.26, <-1.9, 1.5, -0.32>, 0.13 pigment { rgb <0.04, 0.16, 0.1> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cone { <-1.9, 0.36, 1>, 0.26, <-1.9, 1.5, 1>, 0.13 pigment { rgb <0.04, 0.16, 0.1> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
cylinder { <-1.9, 1.55, -0.45>, <-1.9, 1.55, -0.19>, 0.17 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9, 1.55, 0.87>, <-1.9, 1.55, 1.13>, 0.17 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9, 1.55, -0.06>, <-1.9, 1.55, 0.16>, 0.71 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9, 1.55, -0.12>, <-1.9, 1.55, 0.22>, 0.24 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.22, 1.55, 0.05>, 0.092, <-1.03, 1.55, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.2432, 1.726, 0.05>, 0.092, <-1.0596, 1.7752, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.3111, 1.89, 0.05>, 0.092, <-1.1466, 1.985, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.4192, 2.0308, 0.05>, 0.092, <-1.2848, 2.1652, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.56, 2.1389, 0.05>, 0.092, <-1.465, 2.3034, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.724, 2.2068, 0.05>, 0.092, <-1.6748, 2.3904, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 2.23, 0.05>, 0.092, <-1.9, 2.42, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.076, 2.2068, 0.05>, 0.092, <-2.1252, 2.3904, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.24, 2.1389, 0.05>, 0.092, <-2.335, 2.3034, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.3808, 2.0308, 0.05>, 0.092, <-2.5152, 2.1652, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.4889, 1.89, 0.05>, 0.092, <-2.6534, 1.985, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.5568, 1.726, 0.05>, 0.092, <-2.7404, 1.7752, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.58, 1.55, 0.05>, 0.092, <-2.77, 1.55, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.5568, 1.374, 0.05>, 0.092, <-2.7404, 1.3248, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.4889, 1.21, 0.05>, 0.092, <-2.6534, 1.115, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.3808, 1.0692, 0.05>, 0.092, <-2.5152, 0.9348, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.24, 0.9611, 0.05>, 0.092, <-2.335, 0.7966, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-2.076, 0.8932, 0.05>, 0.092, <-2.1252, 0.7096, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.9, 0.87, 0.05>, 0.092, <-1.9, 0.68, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.724, 0.8932, 0.05>, 0.092, <-1.6748, 0.7096, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.56, 0.9611, 0.05>, 0.092, <-1.465, 0.7966, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.4192, 1.0692, 0.05>, 0.092, <-1.2848, 0.9348, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.3111, 1.21, 0.05>, 0.092, <-1.1466, 1.115, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.2432, 1.374, 0.05>, 0.092, <-1.0596, 1.3248, 0.05>, 0.05 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.4705, 1.798, -0.09>, <-1.4705, 1.798, 0.19>, 0.088 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9, 2.046, -0.09>, <-1.9, 2.046, 0.19>, 0.088 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.3295, 1.798, -0.09>, <-2.3295, 1.798, 0.19>, 0.088 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-2.3295, 1.302, -0.09>, <-2.3295, 1.302, 0.19>, 0.088 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.9, 1.054, -0.09>, <-1.9, 1.054, 0.19>, 0.088 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.4705, 1.302, -0.09>, <-1.4705, 1.302, 0.19>, 0.088 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.0515, 0.7015, -0.06>, <-1.0515, 0.7015, 0.16>, 0.31 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.0515, 0.7015, -0.12>, <-1.0515, 0.7015, 0.22>, 0.12 pigment { rgb <0.8, 0.52, 0.16> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.2495, 0.8995, 0.05>, 0.092, <-1.3838, 1.0338, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.3219, 0.7739, 0.05>, 0.092, <-1.5055, 0.8231, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.3219, 0.629, 0.05>, 0.092, <-1.5055, 0.5798, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.2495, 0.5035, 0.05>, 0.092, <-1.3838, 0.3691, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.1239, 0.431, 0.05>, 0.092, <-1.1731, 0.2475, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-0.979, 0.431, 0.05>, 0.092, <-0.9298, 0.2475, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-0.8535, 0.5035, 0.05>, 0.092, <-0.7191, 0.3691, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-0.781, 0.629, 0.05>, 0.092, <-0.5975, 0.5798, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-0.781, 0.7739, 0.05>, 0.092, <-0.5975, 0.8231, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-0.8535, 0.8995, 0.05>, 0.092, <-0.7191, 1.0338, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-0.979, 0.9719, 0.05>, 0.092, <-0.9298, 1.1555, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.1239, 0.9719, 0.05>, 0.092, <-1.1731, 1.1555, 0.05>, 0.05 pigment { rgb <0.78, 0.3, 0.13> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.291, 0.7657, -0.09>, <-1.291, 0.7657, 0.19>, 0.044 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.2268, 0.5261, -0.09>, <-1.2268, 0.5261, 0.19>, 0.044 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.9873, 0.4619, -0.09>, <-0.9873, 0.4619, 0.19>, 0.044 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.8119, 0.6373, -0.09>, <-0.8119, 0.6373, 0.19>, 0.044 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-0.8761, 0.8768, -0.09>, <-0.8761, 0.8768, 0.19>, 0.044 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.1157, 0.941, -0.09>, <-1.1157, 0.941, 0.19>, 0.044 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cylinder { <-1.0515, 0.7015, -0.4>, <-1.0515, 0.7015, 0.5>, 0.06 pigment { rgb <0.5, 0.52, 0.55> } finish { diffuse 0.5 reflection 0.22 phong 0.9 phong_size 60 metallic } }
cone { <-1.0515, 0.36, 0.4>, 0.2, <-1.0515, 0.7015, 0.4>, 0.08 pigment { rgb <0.04, 0.16, 0.1> } finish { reflection 0.06 phong 0.6 phong_size 80 } }
