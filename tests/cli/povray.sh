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
    expect 0 ./povray small.pov Width=20 Height=10.99
    [ "$("$PYTHON" "$pixels" size small.png)" = "20 10 8" ]
}

povray_tells_its_version_and_helps() {
    ln -s "$povc" povray
    for word in --version -version; do
        expect 0 ./povray "$word"
        says out "(libpovtrace "
        says out "POV-Ray 3.7"
    done
    for word in --help -help -h '-?'; do
        expect 0 ./povray "$word"
        says out "Usage: povc SCENE"
    done
}

povray_parts_stand_in_the_whole_picture() {
    small_scene
    expect 0 "$povc" small.pov 20 10 part.pfm --crop 4,2,10,6
    expect 0 "$povc" +Ismall.pov +W20 +H10 +SC5 +EC10 +SR3 +ER6 +FN16 +Opart -D
    [ "$("$PYTHON" "$pixels" size part.png)" = "20 10 16" ]
}

povray_ends_of_1_are_those_of_the_picture() {
    small_scene
    expect 0 "$povc" +Ismall.pov +W20 +H10 +Owhole.png
    expect 0 "$povc" +Ismall.pov +W20 +H10 +SC1 +EC1 +SR1 +ER1.0 +Opart.png
    cmp whole.png part.png
}

povray_animations_are_numbered() {
    small_scene
    expect 0 "$povc" small.pov +W4 +H4 +KFF12 +SF9 +EF10 +Oframe
    [ "$(ls frame*)" = "$(printf 'frame09.png\nframe10.png')" ]
}

povray_antialiasing_asks_for_an_error() {
    rich_scene
    expect 0 "$povc" +Irich.pov +W64 +H48 +A0.3 +Oaa
    says err "stopped: target error reached"
}

povray_errors_end_in_1_and_unknown_settings_do_not() {
    small_scene
    expect 1 "$povc" +Inone.pov +W4 +H4
    says err "none.pov: error: cannot open"
    expect 1 "$povc" +Ismall.pov +Wide
    says err "Width must be a whole number"
    expect 0 "$povc" +Ismall.pov +W4x +H3
    says err "Width=4x is read as 4"
    expect 1 "$povc" +Ismall.pov +Wide
    says err "Width must be a whole number"
    expect 0 "$povc" +Ismall.pov +W4 +H4 Nonsense=3 +MV3.6
    says err '"Nonsense" is not a setting of povc; it is left out'
}

# Frames, sizes and declared names reach the scene's text.
povray_animations_have_a_clock() {
    cat > moving.pov <<'END'
#version 3.7;
#debug concat(str(clock, 0, 2), " ", str(frame_number, 0, 0), "/", str(final_frame, 0, 0), " ", Name, "\n")
camera { location <0, 0, -5> look_at 0 }
light_source { <5, 5, -9> rgb 1 }
sphere { <clock, 0, 0>, N pigment { rgb 1 } }
END
    expect 0 "$povc" +Imoving.pov +W40 +H30 +KFF3 'Declare=Name="x y"' Declare=N=0.5 -V
    says err "0.00 1/3 x y"
    says err "0.50 2/3 x y"
    says err "1.00 3/3 x y"
    [ "$(ls moving*.png)" = "$(printf 'moving1.png\nmoving2.png\nmoving3.png')" ]
    expect 0 "$povc" moving.pov 40 30 own.png -D N=0.5 -D 'Name="x y"'
    same own.png moving1.png
    expect 2 "$povc" moving.pov 40 30 own.png -D N=big
    says err 'must be a number or a string in quotation marks, not "big"'
}

povray_library_paths_are_searched() {
    mkdir inc
    echo '#declare R = 1;' > inc/radius.inc
    printf '#include "radius.inc"\nsphere { 0, R pigment { rgb 1 } }\n' > scene.pov
    expect 1 "$povc" +Iscene.pov +W4 +H4
    says err 'radius.inc'
    expect 0 "$povc" +Iscene.pov +W4 +H4 +Linc
    expect 0 "$povc" scene.pov 4 4 a.png -L inc
}

# Other formats are written without it, and say so.
povray_alpha_is_written() {
    small_scene
    expect 0 "$povc" small.pov 20 10 own.png --alpha --bits 16
    expect 0 "$povc" +Ismall.pov +W20 +H10 +UA +FN16 +Oother
    same own.png other.png
    expect 0 "$povc" +Ismall.pov +W20 +H10 +UA +FP +Oplain
    says err "without transparency"
    expect 2 "$povc" small.pov 20 10 own.ppm --alpha
    says err "alpha cannot be stored in a .ppm file"
}

povray_adds_the_ending_of_a_scene() {
    small_scene
    expect 0 "$povc" +Ismall +W20 +H10
    [ "$("$PYTHON" "$pixels" size small.png)" = "20 10 8" ]
}

povray_stills_have_no_frames() {
    echo '#debug str(clock, 0, 2) #debug str(clock_on + frame_number + initial_frame + final_frame + clock_delta, 0, 0)' > s.pov
    expect 0 "$povc" +Is.pov +W4 +H3 -F
    says err 0.000
    expect 0 "$povc" +Is.pov +W4 +H3 -F +K0.5
    says err 0.501
    expect 0 "$povc" +Is.pov +W4 +H3 -F +KC +KFF2
    says err 0.006
    says err 0.508
}

povray_writes_tga_and_bmp() {
    small_scene
    expect 0 "$povc" +Ismall.pov +W21 +H10 +FT
    [ "$(wc -c < small.tga)" = 648 ]
    expect 0 "$povc" +Ismall.pov +W21 +H10 +FC16 +UA +Oc
    [ "$(wc -c < c.tga)" = 858 ]
    says err "written without compression"
    expect 0 "$povc" +Ismall.pov +W21 +H10 Output_File_Type=B
    [ "$(wc -c < small.bmp)" = 694 ]
    expect 0 "$povc" small.pov 21 10 own.bmp --alpha
    [ "$(wc -c < own.bmp)" = 894 ]
    expect 1 "$povc" +Ismall.pov +W21 +H10 +FS
    says err 'there is no file type "S"'
}

# As POV-Ray does; its +I- does not work in 3.7.0.10, ours does.
povray_pictures_stand_beside_their_scene() {
    mkdir sub lib
    small_scene sub/s.pov
    small_scene lib/found.pov
    expect 0 "$povc" +Isub/s.pov +W4 +H3
    [ -s sub/s.png ]
    expect 0 "$povc" +Isub/s.pov +W4 +H3 +Oname
    [ -s name.png ]
    expect 0 "$povc" +Llib +Ifound +W4 +H3
    [ -s found.png ]
}

povray_writes_radiance_pictures() {
    small_scene
    expect 0 "$povc" +Ismall.pov +W20 +H10 +FH
    head -c 10 small.hdr | grep -q '#?RADIANCE'
    [ "$(wc -c < small.hdr)" -gt 800 ]
}
