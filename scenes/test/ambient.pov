// Ambient light times the finish's ambient times the pigment, whatever the lights do.
global_settings { ambient_light rgb <1, 0.8, 0.6> }
camera { location <0, 0, -5> look_at <0, 0, 0> }
sphere { <-1.2, 0, 0>, 1 pigment { color rgb <0.5, 0.9, 0.7> } finish { ambient 0.7 } }
box { <0.2, -1, -0.5>, <2, 1, 1> pigment { color rgb <0.9, 0.5, 0.4> } }
