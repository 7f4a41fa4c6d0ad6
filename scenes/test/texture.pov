// A texture holds pigment and finish and takes back what was said before it; a finish after it changes what
// it names.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -6> look_at <0, 0, 0> }
light_source { <3, 5, -6> rgb 1 }
sphere { <-2, 0, 0>, 0.9 texture { pigment { rgb <0.9, 0.4, 0.3> } finish { phong 0.8 diffuse 0.8 } } }
sphere { <0, 0, 0>, 0.9 finish { ambient 0.9 phong 1 } texture { pigment { rgb <0.4, 0.8, 0.4> } } }
sphere { <2, 0, 0>, 0.9 texture { pigment { rgb <0.4, 0.4, 0.9> } finish { phong 0.8 } }
    finish { diffuse 0.3 } }
