#version 3.7;
// An open cone cut out of a box: where its ends lack, the box stays whole.
global_settings { assumed_gamma 1 }
camera { location <0.5, 0.7, -4> look_at 0 angle 45 }
background { rgb <0.1, 0.2, 0.4> }
light_source { <-3, 5, -6>, 1 }
difference {
  box { <-1, -0.5, -1>, <0.5, 0.25, 0.25> }
  cone { <0, -0.5, 0>, 0.5, <0, 0.5, 0>, 0.25 open }
  rotate <90, 90, 61>
  pigment { rgb <1, 0.8, 0.5> }
}
