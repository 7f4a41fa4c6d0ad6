// What phong_metallic_course.pov means, for POV-Ray. Each ball has its own two lights, which add up to the
// one of the
// scene: an ordinary one in the highlight's colour, and for the rest a shadowless one, which makes no
// highlights.
// No shadow falls on either ball, so the diffuse light is the same.
#version 3.7;
global_settings { assumed_gamma 1 ambient_light rgb 0 }
camera { location <0, 0.5, -6> right <1.33333, 0, 0> look_at <0, 0, 0> }
light_group {
    light_source { <3, 5, -2> rgb <0.9, 0.6, 0.2> }
    light_source { <3, 5, -2> rgb <0.1, 0.4, 0.8> shadowless }
    sphere { <-1.2, 0, 0>, 1 pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.8 phong_size 8 } }
}
light_group {
    light_source { <3, 5, -2> rgb <0.95, 0.8, 0.6> }
    light_source { <3, 5, -2> rgb <0.05, 0.2, 0.4> shadowless }
    sphere { <1.2, 0, 0>, 1 pigment { rgb <0.9, 0.6, 0.2> } finish { phong 0.8 phong_size 8 } }
}
