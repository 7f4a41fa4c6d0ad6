// Light of the sky on a floor, grey in part and brighter than it is; the sky is the same everywhere.
#version 3.7;
global_settings {
  assumed_gamma 1
  radiosity { count 400 recursion_limit 1 error_bound .2 brightness 1.25 gray_threshold .25 pretrace_start .08 pretrace_end .02 }
}
camera { location <0, 2, -4> look_at <0, 0, 1> }
background { rgb <.3, .5, .8> }
plane { y, 0 pigment { checker rgb <1, .8, .5> rgb <.3, .5, .2> } finish { ambient 0 diffuse .7 } }
