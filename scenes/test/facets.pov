// Normals in cells of the space, and of directions.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -7> look_at <0, 0, 0> angle 45 }
light_source { <4, 8, -9> rgb 1 }
sphere { <-1.4, 0, 0>, 1.3 pigment { rgb <.9, .8, .6> } finish { phong .7 } normal { facets coords .4 scale 2 } }
sphere { <1.4, 0, 0>, 1.3 pigment { rgb <.7, .8, .9> } finish { phong .7 } normal { facets size .3 } }
