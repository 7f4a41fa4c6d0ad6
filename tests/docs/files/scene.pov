camera { location <0, 1, -5> look_at <0, 1, 0> angle 40 }
light_source { <10, 10, -10> color rgb 1 }
sphere { <0, 1, 0>, 1
    pigment { color rgb <1, .4, .2> }
    finish { phong .8 reflection .2 }
}
