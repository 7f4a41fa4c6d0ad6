// Three bounces in a closed sphere; what hangs in it is lit by it and is not seen by it.
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { count 200 recursion_limit 3 error_bound .3 adc_bailout .001 pretrace_start .08 pretrace_end .02 }
}
camera { location <0, 0, -4> look_at 0 }
sphere { 0, 10 pigment { rgb <1, .8, .6> } finish { ambient 1 diffuse .5 emission .2 } }
union {
  sphere { <-1.2, 0, 0>, .8 pigment { rgb <.9, .4, .3> } finish { diffuse .9 } }
  box { <.4, -.7, -.5>, <1.8, .7, .5> pigment { rgb <.3, .7, .9> } finish { diffuse albedo .8 brilliance 3 } rotate 30*y }
  no_radiosity
}
