// CRLF line ends, tabs, a יאü in Latin-1, and no end of the last line.
#version 3.7;
global_settings {	assumed_gamma 1 }
camera { location	<0, 1, -4>
	look_at <0, 0, 0> }
light_source { <4, 6, -6> rgb 1 } // für alle
sphere { 0, 1.2
	pigment { rgb <0.8, 0.6, 0.9> }
} // ©