// A box of smoke that absorbs and glows, and a ball of it, before a wall; the ball overlaps the box.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.5, -6> look_at <0, 0, 0> angle 45 }
light_source { <-4, 6, -6> rgb 1 }
plane { z, 3 hollow pigment { checker rgb <0.8, 0.8, 0.7> rgb <0.3, 0.4, 0.6> } }
box { <-1.6, -1, -0.6>, <0.4, 0.9, 0.8> hollow pigment { rgbt 1 }
      interior { media { absorption <0.3, 0.6, 1> emission <0.1, 0.02, 0> method 2 samples 40, 40 } } }
sphere { <0.8, 0.1, 0>, 1 hollow pigment { rgbt 1 }
         interior { media { absorption <0.9, 0.4, 0.2> method 2 samples 40, 40 } } }
