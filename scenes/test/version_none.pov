// No version and no assumed_gamma, as most old scenes: nothing is converted, and a filter takes less from the
// diffuse light.
camera { location <0, 0.5, -4> look_at <0, 0, 0> }
light_source { <3, 5, -4> rgb 1 }
background { rgb <0.3, 0.2, 0.1> }
sphere { <0, 0, 0>, 1.2 pigment { rgbf <0.6, 0.5, 0.25, 0.7> } }
