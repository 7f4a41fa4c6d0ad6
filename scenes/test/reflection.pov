// Mirrors show their surroundings, each other, and what is behind the camera.
global_settings { ambient_light rgb <1, 1, 1> }
camera { location <0, 1.5, -6> look_at <0, 0, 0> }
light_source { <3, 6, -5> color rgb <1, 1, 1> }
sphere { <-1.2, 0, 0>, 1 pigment { color rgb <0.2, 0.1, 0.1> } finish { reflection 0.7 } }
sphere { <1.2, 0, 0>, 1 pigment { color rgb <0.1, 0.1, 0.3> } finish { reflection 0.5 phong 0.5 } }
box { <-5, -1.2, -4>, <5, -1, 5> pigment { color rgb <0.5, 0.7, 0.4> } }
box { <-6, -3, -12>, <6, 5, -10> pigment { color rgb <0.9, 0.5, 0.3> } finish { ambient 0.6 } }
