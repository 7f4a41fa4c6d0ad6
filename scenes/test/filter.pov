// A filter colours what is seen through it, at each surface, and takes its part from the ambient and diffuse
// light.
global_settings { ambient_light rgb <1, 1, 1> }
camera { location <0, 0, -6> look_at <0, 0, 0> }
light_source { <-3, 5, -6> color rgb <1, 1, 1> }
box { <-3, -2, 2>, <3, 2, 2.5> pigment { color rgb <1, 0.9, 0.8> } finish { ambient 0.4 } }
box { <-1.5, -1, 0>, <-0.2, 1, 0.3> pigment { color rgbf <0.9, 0.4, 0.3, 0.7> } }
box { <0.2, -1, 0>, <1.5, 1, 0.3> pigment { color rgbf <0.4, 0.9, 0.5, 0.4> } }
