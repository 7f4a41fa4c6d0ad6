// A planet a million million times as large as the screw that stands on it, with its moon above the horizon.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
#declare Planet = 1e10;
camera { location <0, .012, -.045> look_at <0, .0085, 0> angle 38 }
light_source { <-3e11, 4e11, -2e11> rgb 1.1 }
background { rgb <.01, .015, .04> }
sphere { -Planet*y, Planet pigment { rgb <.55, .33, .2> } finish { ambient .03 diffuse .8 } }
sphere { <-2.5e10, 1.5e10, 1.2e11>, 9e9 pigment { bozo scale 3e9 turbulence .4 color_map { [.3 rgb .75] [.7 rgb .35] } } finish { ambient 0 } }
#declare Steel = texture { pigment { rgb <.7, .72, .75> } finish { ambient .05 diffuse .35 specular .9 roughness .02 metallic reflection { .35 metallic } } }
union {
    cylinder { 0, .014*y, .0022 }
    sphere_sweep { linear_spline 161,
        #for (I, 0, 160) <.0024*cos(I*pi/10), .0008 + I*.00008, .0024*sin(I*pi/10)>, .0004 #end }
    difference {
        cylinder { .014*y, .0172*y, .005 }
        box { <-.006, .0155, -.0006>, <.006, .02, .0006> rotate 30*y }
    }
    texture { Steel }
}
// Dust beside it.
#declare R = seed(7);
#for (I, 1, 160)
    #local S = .0002 + .0006*pow(rand(R), 3);
    sphere { <.06*(rand(R) - .5), S*.6, .07*(rand(R) - .4)>, S pigment { rgb <.5, .3, .18>*(.6 + .6*rand(R)) } finish { ambient .03 } }
#end
