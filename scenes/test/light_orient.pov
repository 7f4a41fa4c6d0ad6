// An area light that turns to what it lights: nine small shadows of one sphere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,0,-9> look_at 0 angle 40 }
light_source { <1.5,1,-4> rgb 1 area_light 2*x, y, 3, 3 circular orient }
plane { z, 0 inverse pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
sphere { <0.6,0.3,-2>, 0.12 pigment { rgb <1,0.6,0.4> } }
