// A box lit by a patch of the ceiling that emits light, three bounces. POV-Ray's settings: Count, Bound.
#version 3.7;
#ifndef (Count) #declare Count = 400; #end
#ifndef (Bound) #declare Bound = 0.3; #end
global_settings {
    assumed_gamma 1
    max_trace_level 12
    radiosity { recursion_limit 3 count Count error_bound Bound nearest_count 8 low_error_factor 0.6 adc_bailout 0.0005 pretrace_start 0.08 pretrace_end 0.02 }
}
camera { location <0, 0, -0.95> direction 0.75*z right 2*x up 1.5*y look_at z }
#default { finish { ambient 0 diffuse 0.7 } }
union {
    box { <-1, -1.02, -1>, <1, -1, 1> } box { <-1, 1, -1>, <1, 1.02, 1> } box { <-1, -1, 1>, <1, 1, 1.02> } box { <-1, -1, -1.02>, <1, 1, -1> }
    pigment { rgb 1 }
}
box { <-1.02, -1, -1>, <-1, 1, 1> pigment { rgb <0.9, 0.2, 0.2> } }
box { <1, -1, -1>, <1.02, 1, 1> pigment { rgb <0.2, 0.9, 0.2> } }
polygon { 5, <-0.5, -0.5>, <0.5, -0.5>, <0.5, 0.5>, <-0.5, 0.5>, <-0.5, -0.5> rotate 90*x translate 0.999*y
    pigment { rgb 1 } finish { diffuse 0 emission 3 } }
