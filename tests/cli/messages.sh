# What povc says about scenes.

messages_name_the_place_and_point_at_it() {
    printf 'camera { location <0, 0, -4> }\nsphere { <0, 0, 0>, 1 pigment "one" }\n' > wrong.pov
    expect 1 "$povc" wrong.pov 8 8 out.png
    grep -qE '^wrong\.pov:2:[0-9]+: error: ' err
    column=$(sed -n 's/^wrong\.pov:2:\([0-9]*\): error.*/\1/p' err)
    [ "$column" -eq 31 ]
    [ "$(sed -n 2p err)" = '    2 | sphere { <0, 0, 0>, 1 pigment "one" }' ]
    [ "$(sed -n 3p err)" = '      |                               ^' ]
    [ ! -e out.png ]
}

messages_point_at_the_right_place_behind_tabs_and_wide_letters() {
    printf '\tsphere /* \303\251\344\270\255 */ { <0, 0, 0>, 1 "one" }\n' > wrong.pov
    expect 1 "$povc" --check wrong.pov
    tab=$(printf '\t')
    [ "$(sed -n 3p err)" = "      | ${tab}                                ^" ] || fail "$(cat err)"
    "$povc" --check - < wrong.pov 2> err || true
    grep -qE '^<stdin>:1:[0-9]+: error: ' err
}

messages_tell_isosurfaces_whose_max_gradient_counts() {
    printf '#declare N = function { pattern { bozo } } isosurface { function { y - N(x, y, z) } }\n' > noise.pov
    "$povc" --check noise.pov 2> err
    says err "bounds of this function are not known"
    printf 'isosurface { function { y - sin(x) } }\n' > smooth.pov
    "$povc" --check smooth.pov 2> err
    ! grep -q warning err || fail "$(cat err)"
}

messages_defect_18_guess_the_word_that_was_meant() {
    printf 'sphere { <0, 0, 0>, 1 pigmnet { color rgb <1, 1, 1> } }\n' > wrong.pov
    expect 1 "$povc" --check wrong.pov
    says err 'did you mean "pigment"?'
    printf 'Sphere { 0, 1 }\n' > wrong.pov
    expect 1 "$povc" --check wrong.pov
    says err 'did you mean "sphere"?'
    expect 2 "$povc" --treads 3
    says err 'did you mean "--threads"?'
}

messages_defect_13_go_on_behind_an_error_in_the_order_of_lines() {
    printf 'sphere { 0, 1 pigmnt { rgb 1 } }\n#declare A = 3;\nspere { 0, 1 }\n#if (A > 2)\n  cylinder { 0, 1 }\n#end\nbox { 0, A }' > w.pov
    expect 1 "$povc" --check w.pov
    [ "$(sed -n 's/^w\.pov:\([0-9]*\):[0-9]*: error: .*/\1/p' err | tr '\n' ' ')" = "1 3 5 " ]
    says err "povc: 3 errors"
}

# What stands behind an error is read where a statement begins, and where all braces are closed.
messages_do_not_come_again_behind_an_error() {
    for wrong in 'background rgb 1' 'light_source <0, 5, 0> color rgb 1' 'mesh { triangle { 0, x } triangle { 0, x, y } }' \
        'isosurface { function { x } contained_by { cone { 0, 1, y, 0 } } }' 'sphere { 0, 1 pigment { function { sin(x } } }'; do
        printf '%s\nsphere { 0, 1 }\nspere { 0, 1 }\nspere { 0, 1 }\n' "$wrong" > w.pov
        expect 1 "$povc" --check w.pov
        [ "$(sed -n 's/^w\.pov:\([0-9]*\):[0-9]*: error: .*/\1/p' err | tr '\n' ' ')" = "1 3 4 " ]
    done
}

messages_want_meshes_for_cameras_that_see_by_faces() {
    printf 'camera { mesh_camera { 1 0 triangle { 0, x, y } } }\n' > w.pov
    expect 1 "$povc" --check w.pov
    says err "w.pov:1:47: error: a mesh_camera sees by the faces of meshes"
}

messages_guess_names_of_objects() {
    printf '#declare Globe = sphere { 0, 1 }\nobject { globe }\n' > w.pov
    expect 1 "$povc" --check w.pov
    says err 'did you mean "Globe"?'
}

messages_stop_behind_errors_that_would_make_others() {
    for first in '#declare A = ;' '#include "none.inc"' '#macro M() sphere { x #end M()' '#if (1) sphere { #end'; do
        printf '%s\nsphere { 0, wrong }\n' "$first" > w.pov
        expect 1 "$povc" --check w.pov
        [ "$(grep -c ': error: ' err)" -eq 1 ]
    done
}

messages_about_loops_that_do_not_end_say_where() {
    printf '#while (1)\nsphere { 0, 1 } #end' > endless.pov
    expect 1 "$povc" --check --limit memory=1e7 endless.pov
    says err "endless.pov:1:1: error: this loop has made the scene larger than 10000000 bytes"
    printf '#macro M(A) A #end\n#for (I, 0, 1e12) #local B = M(I); #end' > endless.pov
    expect 1 "$povc" --check --limit seconds=.1 endless.pov
    says err "error: reading takes longer than 0.1 seconds"
    expect 1 "$povc" --check --limit turns=1000 endless.pov
    says err "error: more than 1000 turns"
}

messages_about_functions_that_make_images_say_where() {
    printf '#version 3.7;\nsphere { 0, 1 pigment { image_pattern { function 9000, 9000 { pigment { granite } } } } }\n' > large.pov
    expect 1 "$povc" --check --limit seconds=.1 large.pov
    says err "error: reading takes longer than 0.1 seconds"
    expect 1 "$povc" --check --limit images=647999999 large.pov
    says err "error: this image takes 648000000 bytes, of 647999999 that images may still take"
    says err "large.pov:2:"
    printf '#version 3.7;\nheight_field { function 9000, 9000 { pigment { granite } } }\n' > large.pov
    expect 1 "$povc" --check --limit seconds=.1 large.pov
    says err "error: reading takes longer than 0.1 seconds"
}

# F6 of the review: no ceiling on memory for input.
messages_f6_name_the_file_that_is_too_large() {
    small_scene
    expect 1 "$povc" --check --limit input=50 small.pov
    says err "small.pov: error: is larger than the 50 bytes that may still be read"
    printf '#include "small.pov"\n' > outer.pov
    expect 1 "$povc" --check --limit input=50 outer.pov
    says err "larger than the 29 bytes that may still be read"
    expect 0 "$povc" --check --limit input=1000 outer.pov
    expect 1 "$povc" --check --limit input=1e6 /dev/zero
    says err "larger than the 1000000 bytes"
    { printf 'P6 400 300 255\n'; head -c 360000 /dev/zero; } > wide.ppm
    printf '#version 3.7; sphere { 0, 1 pigment { image_map { ppm "wide.ppm" } } }\n' > image.pov
    expect 1 "$povc" --check --limit images=1e5 image.pov
    says err "wide.ppm: this image takes 360000 bytes, of 100000 that images may still take"
    says err "image.pov:1:"
    expect 0 "$povc" --check --limit images=360000 image.pov
}

messages_are_twenty_errors_at_most() {
    for line in $(seq 30); do echo "sphere { $line, wrong }"; done > w.pov
    expect 1 "$povc" --check w.pov
    [ "$(grep -c ': error: ' err)" -eq 20 ]
}

messages_carry_no_terminal_commands_from_a_scene() {
    printf 'sphere { <0, 0, 0>, "\033[2J\233" }\n' > wrong.pov
    expect 1 "$povc" --check wrong.pov
    says_not err "$(printf '\033')"
    says_not err "$(printf '\233')"
}

messages_warn_and_count_and_can_be_silenced() {
    printf 'sphere { <0, 0, 0>, -1 pigment { color rgb <1, 1, 1> } }\n' > odd.pov
    expect 0 "$povc" --check odd.pov
    grep -qE '^odd\.pov:1:[0-9]+: warning: ' err
    says out "1 warning;"
    expect 0 "$povc" odd.pov 4 4 out.png -q
    [ ! -s err ]
    [ ! -s out ]
    expect 0 "$povc" odd.pov 4 4 out.png -q --stats
    says out "warnings: 1"
}

messages_are_coloured_on_a_terminal_only_and_not_against_no_color() {
    printf 'sphere { }\n' > wrong.pov
    cat > terminal.py <<'END'
import os, pty, sys
pid, fd = pty.fork()
if pid == 0:
    os.execvp(sys.argv[1], sys.argv[1:])
text = b""
while True:
    try:
        more = os.read(fd, 4096)
    except OSError:
        break
    if not more:
        break
    text += more
os.waitpid(pid, 0)
sys.stdout.buffer.write(text)
END
    escape=$(printf '\033')
    TERM=xterm "$PYTHON" terminal.py "$povc" --check wrong.pov > on_terminal
    says on_terminal "$escape[1;31merror:"
    TERM=xterm NO_COLOR=1 "$PYTHON" terminal.py "$povc" --check wrong.pov > no_color
    says no_color "error:"
    says_not no_color "$escape"
    TERM=xterm NO_COLOR=1 "$PYTHON" terminal.py "$povc" --check --color always wrong.pov > always
    says always "$escape"
    TERM=xterm "$PYTHON" terminal.py "$povc" --check --color never wrong.pov > never
    says_not never "$escape"
    TERM=dumb "$PYTHON" terminal.py "$povc" --check wrong.pov > dumb
    says_not dumb "$escape"
    expect 1 "$povc" --check wrong.pov
    says_not err "$escape"
}

messages_about_input_that_is_no_file() {
    expect 1 "$povc" no-such-scene.pov 8 8 out.png
    says err "no-such-scene.pov: error:"
    mkdir folder.pov
    expect 1 "$povc" folder.pov 8 8 out.png
    says err "folder.pov: error:"
    [ ! -e out.png ]
}

messages_about_input_without_permission() {
    small_scene secret.pov
    if [ "$(id -u)" -eq 0 ]; then
        # Root may read everything, so somebody else asks, with a copy of the program that anybody may run.
        mkdir app
        cp -R "$BUILD_DIR/bin" "$BUILD_DIR/lib" app/
        chmod -R a+rX "$cases_folder"
        chmod 0 secret.pov
        expect 1 "$PYTHON" -c '
import os, sys
os.setgid(65534); os.setuid(65534)
os.execv(sys.argv[1], sys.argv[1:])' app/bin/povc --check secret.pov
    else
        chmod 0 secret.pov
        expect 1 "$povc" --check secret.pov
    fi
    says err "secret.pov: error:"
    says err "ermission denied"
}

messages_are_json_for_editors() {
    printf 'sphere { 0, 1 pigmnt { rgb 1 } }\n' > "a \"b\".pov"
    expect 1 "$povc" --check --messages json "a \"b\".pov"
    grep -qxF '{"kind":"error","file":"a \"b\".pov","line":1,"column":15,"message":"unknown word \"pigmnt\" in \"sphere\"","hint":"pigment"}' err
}

messages_defect_15_an_open_brace_is_named() {
    printf 'sphere { <0,0,0>, 1 pigment { rgb 1 }\nsphere { <0,0,0>, 1 }\n' > open.pov
    expect 1 "$povc" open.pov 8 6 o.png
    says err 'does not belong in "sphere", whose "{" at 1:8 is still open'
}

messages_defect_20_a_black_picture_is_explained() {
    echo 'sphere { <0,0,5>, 1 }' > dark.pov
    expect 0 "$povc" dark.pov 8 6 o.png
    says err "the picture is black: the scene has no light source"
    echo 'light_source { 9*y rgb 1 }' > empty.pov
    expect 0 "$povc" empty.pov 8 6 o.png
    says err "the picture is black: the scene has no object"
    for text in '' '// only a comment' '/* and another */'; do
        printf '%s' "$text" > nothing.pov
        expect 0 "$povc" nothing.pov 8 6 o.png
        says err "the picture is black: the scene has no object"
    done
    echo 'light_source { 9*y rgb 1 } sphere { 0, 1 }' > inside.pov
    expect 0 "$povc" inside.pov 8 6 o.png
    says err "nothing is in view, or no light reaches it; there is no camera, so it stands at <0, 0, 0>"
    small_scene
    expect 0 "$povc" small.pov 8 6 o.png
    [ ! -s err ]
}

messages_f11_a_map_without_inverse_has_a_place() {
    awk 'BEGIN { printf "\n sphere { 0,1 "; for (i = 0; i < 400; i++) printf "scale 10 "; print "}" }' > f11.pov
    expect 1 "$povc" f11.pov 8 6 o.png
    says err "f11.pov:2:2: error: the transformation of this sphere has no inverse"
}

messages_f6_a_reference_is_refused_by_its_header() {
    small_scene
    expect 0 "$povc" small.pov 64 48 big.png
    expect 2 "$povc" small.pov 8 6 o.png --reference big.png --report r.csv
    says err "64 x 48 pixels, where 8 x 6 are wanted"
}

# Scenes that say what they find with #error.
messages_trace_fills_elements_and_parameters() {
    cat > found.pov << 'END'
#declare B = box { -1, 1 }
#declare A = array[2] { x, x }
#macro Hit(N) trace(B, 3*y, -y, N) #end
#declare P = trace(B, -3*y, y, A[0]);
#declare P = Hit(A[1]);
#declare V = x;
#declare P = Hit(V);
#if (A[0].y != -1 | A[1].y != 1 | V.y != 1 | P.y != 1) #error "another normal" #end
END
    expect 0 "$povc" --check found.pov
}

messages_planes_narrow_extents_as_in_povray() {
    cat > boxes.pov << 'END'
#macro Check(I, Lo, Hi)
    #if (vlength(min_extent(I) - Lo) > 1e-6 | vlength(max_extent(I) - Hi) > 1e-6) #error "another box" #end
#end
#declare S = sphere { 0, 1 }
#declare I = intersection { object { S } plane { y, 0 } } Check(I, -1, <1, 0, 1>)
#declare I = intersection { object { S } plane { y, 0 rotate 90*z } } Check(I, <0, -1, -1>, 1)
#declare I = intersection { object { S } plane { y, .5 inverse } } Check(I, <-1, .5, -1>, 1)
#declare I = intersection { object { S } plane { x + y, 0 } } Check(I, -1, 1)
#declare I = intersection { object { S } plane { y, 0 } rotate 180*x } Check(I, <-1, 0, -1>, 1)
#declare I = difference { object { S } plane { y, 0 } plane { -x, -.5 } } Check(I, <-1, 0, -1>, <.5, 1, 1>)
#declare I = intersection { plane { x, 1 } plane { -x, 2 } plane { y, 1 } plane { -y, 2 } plane { z, 1 } plane { -z, 2 } } Check(I, -2, 1)
#declare I = intersection { plane { x, 1 } plane { -x, 2 } } Check(I, -1e10, 1e10)
#declare I = intersection { object { S } plane { y, -2 } } Check(I, -1e10, 1e10)
END
    expect 0 "$povc" --check boxes.pov
}
