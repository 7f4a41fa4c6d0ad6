// Texts: kerning, an offset a character, letters cut out of a slab, letters of glass.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
camera { location <3.4,2.4,-6.5> look_at <3,.3,0> angle 52 }
light_source { <-5,8,-9> rgb 1 }
plane { y, -1.6 pigment { rgb <.5,.6,.7> } }
text { ttf "timrom.ttf" "AVATo fi &@" .4, 0 pigment { rgb <1,.7,.3> } finish { phong .6 } }
text { ttf "cyrvetic.ttf" "Wave 8@" .3, <.1,.05,0> pigment { rgb <.4,.9,.3> } translate 1.1*y }
difference { box { <-.5,-1.4,0>, <7,-.4,.5> } text { ttf "crystal.ttf" "Engraved" 1, 0 translate <0,-1.1,-.7> pigment { rgb <.8,.2,.2> } } pigment { rgb .8 } }
text { internal 1 "gl" .3, 0 translate <5,1,-1> pigment { rgbf <.9,1,.9,.9> } interior { ior 1.2 } }
