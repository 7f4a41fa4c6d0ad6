# Animations: --frames, and POV-Ray's words for them.

moving_scene() {
    cat > moving.pov <<'END'
#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat("clock ", str(clock, 0, 2), " ", str(frame_number, 0, 0), "/", str(final_frame, 0, 0), "\n")
#ifdef (Broken) #if (frame_number = Broken) #error "this one is broken" #end #end
camera { location <0, 0, -5> look_at 0 }
light_source { <5, 5, -9> rgb 1 }
sphere { <clock, 0, 0>, 1 pigment { rgb 1 } }
END
}

frames_are_numbered_and_have_clocks() {
    moving_scene
    expect 0 "$povc" moving.pov 20 15 out.png --frames 8..10
    [ "$(ls out*.png)" = "$(printf 'out08.png\nout09.png\nout10.png')" ]
    says err "clock 0.00 8/10"
    says err "clock 0.50 9/10"
    says err "clock 1.00 10/10"
    expect 0 "$povc" moving.pov 20 15 other.png --frames 1..3 --clock -1,2
    says err "clock 0.50 2/3"
    same out09.png other2.png
    expect 0 "$povc" moving.pov -s 20x15 --frames 0..1
    same moving0.png out08.png
}

frames_that_fail_do_not_end_the_rest() {
    moving_scene
    expect 1 "$povc" moving.pov 20 15 out.png --frames 1..3 -D Broken=2
    [ "$(ls out*.png)" = "$(printf 'out1.png\nout3.png')" ]
    says err "this one is broken"
    says err "frame 2 is left out"
    says err "1 of 3 frames failed"
    expect 1 "$povc" +Imoving.pov +W20 +H15 +Opov +KFF3 Declare=Broken=1
    [ "$(ls pov*)" = "$(printf 'pov2.png\npov3.png')" ]
    same pov3.png out3.png
}

frames_all_fail_at_once_where_the_reason_is_theirs() {
    moving_scene
    expect 1 "$povc" none.pov 20 15 out.png --frames 1..3
    [ "$(grep -c 'cannot open' err)" = 1 ]
    expect 1 "$povc" moving.pov 20 15 none/out.png --frames 1..3
    [ "$(grep -c 'cannot write' err)" = 1 ]
}

frames_that_are_there_stay_with_resume() {
    moving_scene
    expect 0 "$povc" moving.pov 20 15 out.png --frames 1..3
    cp out3.png kept.png
    echo kept > out2.png
    rm out3.png
    expect 0 "$povc" moving.pov 20 15 out.png --frames 1..3 --resume
    says err "2 of 3 frames were there already"
    [ "$(cat out2.png)" = kept ]
    same out3.png kept.png
    echo kept > out3.png
    expect 0 "$povc" +Imoving.pov +W20 +H15 +Oout +KFF3 +C
    [ "$(cat out3.png)" = kept ]
    expect 0 "$povc" +Imoving.pov +W20 +H15 +Oout +KFF3
    same out3.png kept.png
}

frames_go_into_a_pipe_one_behind_the_other() {
    moving_scene
    expect 0 "$povc" moving.pov 20 15 out.png --frames 1..3
    expect 0 "$povc" moving.pov 20 15 - --frames 1..3
    cat out1.png out2.png out3.png > all
    same out all
    "$povc" moving.pov 20 15 - --frames 1..3 -q > piped 2> err
    cmp piped all
    if command -v ffmpeg > /dev/null; then
        "$povc" moving.pov 20 16 - --frames 1..8 -q 2> err | ffmpeg -loglevel error -f image2pipe -c:v png -i - film.mkv
        [ "$(ffprobe -loglevel error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 film.mkv)" = 8 ]
    fi
}

frames_have_one_progress() {
    moving_scene
    expect 0 "$povc" moving.pov 20 15 out.png --frames 1..4 --progress json
    grep '"percent"' err > lines
    [ "$(wc -l < lines)" -ge 4 ]
    tail -n 1 lines | grep -q '"percent":100,.*"frame":4,"frames_done":3,"frames":4}'
    [ "$(grep -c '"percent":100,' lines)" = 1 ]
    grep -q '"percent":25.0,.*"frame":1,' lines
}

frames_of_maps_are_numbered_too() {
    moving_scene
    expect 0 "$povc" moving.pov 20 15 out.png --frames 1..2 --aov depth depth.pfm
    [ "$(ls depth*)" = "$(printf 'depth1.pfm\ndepth2.pfm')" ]
    ! cmp -s depth1.pfm depth2.pfm
}

frames_are_asked_for_rightly() {
    moving_scene
    for wrong in "--frames 3..1" "--frames 3" "--frames a..b" "--frames -1..2" "--clock 1,2" "--frames 1..2 --clock 1" \
                 "--frames 1..2 --part 1/2" "--frames 1..2 --explain"; do
        expect 2 "$povc" moving.pov 20 15 out.png $wrong
    done
    [ -z "$(ls out*.png 2> /dev/null)" ]
}
