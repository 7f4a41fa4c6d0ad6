// In POV-Ray's dialect `sky` is the vertical, and of `up` and `right` only the lengths count.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { sky <0.5, 1, 0.2> up <0, 1.2, 0.5> right <1.5, 0, 0.3> location <1, 2, -6> look_at <0, 0, 0> }
light_source { <4, 8, -8> rgb 1 }
box { -1, 1 pigment { rgb <0.7, 0.8, 0.4> } }
cylinder { <0, 1, 0>, <0, 1.8, 0>, 0.3 pigment { rgb <0.4, 0.5, 0.8> } }
