// Soft shadows: a lamp of 6 x 6 points, a round one, and a spotlight with an area.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0,3.4,-8> look_at <0,0.9,0> angle 46 }
background { rgb <0.02,0.03,0.05> }
light_source { <-4,6,-3> rgb <0.9,0.8,0.65> area_light <1.6,0,0>, <0,0,1.6>, 6, 6 fade_distance 8 fade_power 2 }
light_source { <4,5,-4> rgb <0.25,0.35,0.6> area_light <0.8,0,0.8>, <0,1.1,0>, 5, 5 circular }
light_source {
    <0.5,7,1> rgb <0.8,0.8,0.8>
    spotlight point_at <0.4,0,0.3> radius 9 falloff 16 tightness 1
    area_light <0.8,0,0>, <0,0,0.8>, 4, 4
}
plane { y, 0 pigment { checker rgb <0.85,0.83,0.8> rgb <0.6,0.58,0.55> } }
sphere { <-1.6,1,0.2>, 1 pigment { rgb <0.9,0.3,0.2> } finish { phong 0.6 phong_size 60 } }
torus { 0.7, 0.22 rotate <70,20,0> translate <0.6,0.9,-0.3> pigment { rgb <0.95,0.75,0.3> } finish { phong 0.8 phong_size 40 } }
difference {
    box { <1.7,0,-0.3>, <3.1,1.4,1.1> }
    cylinder { <2.4,0.7,-1>, <2.4,0.7,2>, 0.45 }
    pigment { rgb <0.35,0.6,0.45> }
}
union {
    cylinder { <-0.4,0,1.8>, <-0.4,2.6,1.8>, 0.08 }
    cylinder { <0.1,0,1.8>, <0.1,2.6,1.8>, 0.08 }
    cylinder { <0.6,0,1.8>, <0.6,2.6,1.8>, 0.08 }
    pigment { rgb 0.7 }
}
