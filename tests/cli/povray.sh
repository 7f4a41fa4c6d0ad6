# POV-Ray's command line, as scripts write it.

povray_options_draw_what_povc_draws() {
    small_scene
    expect 0 "$povc" small.pov 40 30 own.ppm
    expect 0 "$povc" +Ismall.pov +W40 +H30 +FP +Oother.ppm -D -GA
    same own.ppm other.ppm
    expect 0 "$povc" +I- +O- +FP +W40 +H30 < small.pov
    same own.ppm out
}

povray_ini_files_draw() {
    small_scene
    printf 'Width=20\nHeight=10\nInput_File_Name=small.pov\n[big]\nWidth=40\nHeight=30\nOutput_File_Type=P\n' > quick.ini
    expect 0 "$povc" quick.ini
    [ "$("$PYTHON" "$pixels" size small.png)" = "20 10 8" ]
    expect 0 "$povc" 'quick.ini[big]' +Obig
    expect 0 "$povc" small.pov 40 30 own.ppm
    same own.ppm big.ppm
}

povray_is_also_a_name() {
    small_scene
    ln -s "$povc" povray
    expect 0 ./povray small.pov Width=20 Height=10
    [ "$("$PYTHON" "$pixels" size small.png)" = "20 10 8" ]
}

povray_parts_stand_in_the_whole_picture() {
    small_scene
    expect 0 "$povc" small.pov 20 10 part.pfm --crop 4,2,10,6
    expect 0 "$povc" +Ismall.pov +W20 +H10 +SC5 +EC10 +SR3 +ER6 +FN16 +Opart -D
    [ "$("$PYTHON" "$pixels" size part.png)" = "20 10 16" ]
}

povray_animations_are_numbered() {
    small_scene
    expect 0 "$povc" small.pov +W4 +H4 +KFF12 +SF9 +EF10 +Oframe
    [ "$(ls frame*)" = "$(printf 'frame09.png\nframe10.png')" ]
}

povray_antialiasing_asks_for_an_error() {
    rich_scene
    expect 0 "$povc" +Irich.pov +W64 +H48 +A0.3 +Oaa
    says err "the error asked for ended it"
}

povray_errors_end_in_1_and_unknown_settings_do_not() {
    small_scene
    expect 1 "$povc" +Inone.pov +W4 +H4
    says err "none.pov: error: cannot open"
    expect 1 "$povc" +Ismall.pov +Wide
    says err "Width must be a whole number"
    expect 0 "$povc" +Ismall.pov +W4 +H4 Nonsense=3 +MV3.6
    says err '"Nonsense" is not a setting of povc; it is left out'
}
