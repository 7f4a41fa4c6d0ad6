#!/bin/sh
# The real window, under Xvfb: mouse, keys, the scene's file saved, another size, the end; looked at by screenshots.
# Usage: BUILD_DIR=build tests/viewer/window.sh. Ends with "N passed, N failed".
set -u
root=$(cd "$(dirname "$0")/../.." && pwd) || exit 1
povview=$(cd "${BUILD_DIR:-$root/build}" && pwd)/bin/povview
for tool in Xvfb xdotool import compare convert; do
    if ! command -v "$tool" >/dev/null 2>&1; then
        echo "there is no $tool to test the window with"
        exit 2
    fi
done
work=$(mktemp -d) || exit 1
server= viewer=
end() {
    [ -n "$viewer" ] && kill "$viewer" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null
    rm -rf "$work"
}
trap end EXIT
cd "$work" || exit 1
passed=0 failed=0
export XDG_STATE_HOME="$work/state"   # the list of recent scenes is not the user's own

# check NAME COMMAND...: passes if the command does.
check() {
    name=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
        echo "ok $name"
    else
        failed=$((failed + 1))
        echo "not ok $name"
    fi
}

# within COMMAND...: ask until it is so, for thirty seconds: a machine may be busy.
within() {
    tries=300
    until "$@"; do
        tries=$((tries - 1))
        [ "$tries" -gt 0 ] || return 1
        sleep 0.1
    done
}

# scene BODY: save the scene, in one step, as editors do.
scene() {
    cat > scene.new <<END
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 }
light_source { <-30, 40, -50> rgb 1 }
$1
END
    mv scene.new scene.pov
}

# Without a window it would wait for a click.
shot() { [ -n "$window" ] && import -window "$window" "$1"; }
# channel FILE X Y r|g|b: of a pixel, 0 to 255.
channel() { convert "$1" -crop "1x1+$2+$3" +repage -format "%[fx:round(255*p{0,0}.$4)]" info:; }
# differ FILE FILE: how many pixels do.
differ() { compare -metric AE "$1" "$2" null: 2>&1 | sed 's/[^0-9].*//'; }
is_done() { xdotool getwindowname "$window" 2>/dev/null | grep -q ': done in'; }
is_there() { window=$(xdotool search --name '^scene.pov' 2>/dev/null | head -n 1); [ -n "$window" ]; }

# opens NAME COMMAND...: without a window there is nothing more to check.
opens() {
    name=$1
    shift
    within "$@"
    check "$name" [ -n "$window" ]
    [ -n "$window" ] || { cat err; echo "$passed passed, $failed failed"; exit 1; }
}

# looks FILE X Y r|g|b: take a screenshot; is the pixel of that colour?
looks() {
    shot "$1"
    [ "$(channel "$1" "$2" "$3" "$4")" -gt 90 ]
}
changed() { shot "$1"; [ "$(differ "$1" "$2")" -gt "$3" ]; }
alike() { shot "$1"; [ "$(differ "$1" "$2")" -lt "$3" ]; }
same() { shot "$1"; [ "$(differ "$1" "$2")" -eq 0 ]; }

env -u DISPLAY -u WAYLAND_DISPLAY "$povview" "$root/scenes/test/sphere.pov" >out 2>err
check "without a display it says so and names --shot" \
    sh -c '[ $0 -eq 1 ] && grep -q "cannot open a window.*--shot" err' $?

exec 3> display
# Without -noreset it starts over when a viewer has closed, and refuses the next one meanwhile.
Xvfb -noreset -displayfd 3 -screen 0 1024x768x24 -nolisten tcp >/dev/null 2>&1 &
server=$!
exec 3>&-
within test -s display || { echo "Xvfb did not start"; echo "$passed passed, 1 failed"; exit 1; }
DISPLAY=:$(head -n 1 display)
export DISPLAY

scene 'sphere { 0, 1 pigment { rgb <1, 0, 0> } }'
"$povview" scene.pov 400 300 >out 2>err &
viewer=$!
opens "a window opens with the scene's name" is_there
check "the picture becomes whole" within is_done
sleep 5   # the word on the help goes away
xdotool mousemove --window "$window" 200 150
check "the picture is seen" within looks first.png 200 150 r

xdotool mousedown 1
for step in 1 2 3 4 5; do xdotool mousemove_relative 10 4; done
xdotool mouseup 1
check "a drag turns the picture" within changed turned.png first.png 500
within is_done
xdotool key c
check "C prints a camera" within grep -q '^camera {' out
xdotool key Return
check "Enter brings the first picture back" within same again.png first.png

xdotool keydown ctrl click 4 click 4 click 4 keyup ctrl
check "Ctrl and the wheel magnify" within changed near.png first.png 500
xdotool key 0
sleep 2.2   # the word goes away
check "0 shows the same picture" within same again.png first.png
xdotool click 4
check "the wheel goes nearer" within changed near.png first.png 500
xdotool key r
within same again.png first.png

xdotool mousedown 3 keydown w
sleep 0.3
xdotool keyup w mouseup 3
check "W flies with the right button held" within changed flown.png first.png 500
xdotool key r
within same again.png first.png

# toggles KEY WHAT: once shows it, once more takes it away.
toggles() {
    xdotool key "$1"
    check "$1 shows $2" within changed shown.png first.png 500
    xdotool key "$1"
    check "and takes it away" within same again.png first.png
}
# away NAME: something has moved the camera; R undoes it.
away() {
    check "$1" within changed moved.png first.png 500
    xdotool key r
    within same again.png first.png || check "but R does not undo it" false
}
title_says() { xdotool getwindowname "$window" | grep -q "$1"; }

xdotool mousedown 2 mousemove_relative 30 10 mouseup 2
away "a middle drag shifts it"
xdotool mousemove --window "$window" 200 150 keydown shift mousedown 1 mousemove_relative 30 10 mouseup 1 keyup shift
away "so does a drag with Shift"
for side in 3 7; do
    xdotool key $side
    away "$side shows it from another side"
done
xdotool key 7
within changed moved.png first.png 500
xdotool key 1
check "1 shows it from the front, where it was" within alike again.png first.png 50
xdotool key r
within same again.png first.png
xdotool mousemove --window "$window" 200 150

xdotool key bracketright
check "] is brighter" within changed bright.png first.png 5000
xdotool key bracketleft
check "[ is darker again" within same again.png first.png
for view in normal depth samples time error certainty; do
    xdotool key Tab
    check "Tab shows the view of $view" within changed view.png first.png 20000
done
xdotool key Tab
check "and comes round to the picture" within same again.png first.png
toggles h help
toggles F1 help
xdotool key h
within changed shown.png first.png 500
shot help.png
xdotool click 5
check "the wheel scrolls a help that does not fit" within changed scrolled.png help.png 500
xdotool key Up Up Up
check "and Up scrolls it back" within same scrolled.png help.png
xdotool key h
within same again.png first.png
xdotool key F11
size_of() { xdotool getwindowgeometry "$window" | grep -q "$1"; }
check "F11 takes the whole screen" within size_of 'Geometry: 1024x768'
xdotool key F11
check "and gives it back" within size_of 'Geometry: 400x300'
check "with the same picture" within same again.png first.png
toggles g "the error against time"
toggles i "what is under the pointer"
toggles o "clipped pixels, and the legend"
xdotool key p key 3
check "P pauses" within title_says ', paused'
xdotool key p key r
check "and lets it go on" within same again.png first.png
xdotool key s
check "S saves the picture" within test -s scene-001.png
check "of the window's size" test "$(identify -format %wx%h scene-001.png)" = 400x300
within same again.png first.png
xdotool key F5
check "F5 reads it again" within changed again.png first.png 100
check "and it is the same picture" within same again.png first.png
check "the title tells samples and error" title_says 'scene.pov: done in [0-9.]* s, [0-9.]* samples, error 0.00'

scene 'sphere { 0, 1 pigment { rgb <0, 1, 0> } }'
check "a saved file is read again" within looks green.png 200 150 g
# A word says that it was; then only the picture is there.
within is_done
sleep 2.2
shot green.png
scene 'sphere { 0, 1 pigmnet { rgb <0, 0, 1> } }'
check "a wrong file shows a message" within changed wrong.png green.png 3000
check "over the last good picture" test "$(channel wrong.png 200 150 g)" -gt 90
scene 'sphere { 0, 1 pigment { rgb <0, 0, 1> } }'
check "a mended file is shown" within looks blue.png 200 150 b

xdotool windowsize "$window" 600 500
size_is() { shot sized.png; [ "$(identify -format %wx%h sized.png)" = 600x500 ] && [ "$(channel sized.png 300 250 b)" -gt 90 ]; }
check "another size of the window is filled" within size_is
within is_done
# The sphere is as high as before in parts of the window: half of it at 0.2 of the height above the middle is inside.
check "and nothing is stretched" sh -c '[ $0 -gt 60 ] && [ $1 -gt 60 ]' \
    "$(channel sized.png 300 180 b)" "$(channel sized.png 230 250 b)"

xdotool key Escape
gone() { ! kill -0 "$viewer" 2>/dev/null; }
check "Esc ends it" within gone
wait "$viewer"
check "with exit status 0" test $? -eq 0
viewer=
check "and nothing was said on standard error" test ! -s err

# The start page: the scene above is a recent one now.
scene 'sphere { 0, 1 pigment { rgb <1, 0, 0> } }'
mkdir other
sed 's/rgb <1, 0, 0>/rgb <0, 1, 0>/' scene.pov > "other/two words.pov"
named() { window=$(xdotool search --name "$1" 2>/dev/null | head -n 1); [ -n "$window" ]; }
"$povview" >out 2>err &
viewer=$!
opens "without a scene a window opens too" named '^povview$'
check "without a scene it lists recent ones" within sh -c 'import -window "$0" start.png &&
    [ "$(convert start.png -crop 600x300+212+234 -format "%k" info:)" -gt 20 ]' "$window"
shot start.png
xdotool key 9
xdotool key 1
check "the number of one opens it" within named '^scene.pov: done in'
check "as it was" test "$(shot one.png; channel one.png 512 384 r)" -gt 90
if pkg-config --exists x11 && command -v "${CC:-cc}" >/dev/null; then
    "${CC:-cc}" "$root/tests/viewer/drop.c" -o drop $(pkg-config --cflags --libs x11) || echo "drop.c does not compile"
    check "a file can be dropped" ./drop "$window" "$work/other/two%20words.pov"
    check "and is shown" within named '^two words.pov: done in'
    check "in the scene's place" within looks two.png 512 384 g
    check "and is the most recent one" grep -q 'two words' "$XDG_STATE_HOME/povtrace/recent"
    sed 's/rgb <1, 0, 0>/rgb <0, 0, 1>/' scene.pov > new.pov
    mv new.pov "other/two words.pov"
    check "and its file is the one that is watched" within looks blue.png 512 384 b
fi
xdotool key ctrl+q
check "Ctrl and Q end it" within gone
viewer=
check "and nothing was said on standard error" test ! -s err

[ "$failed" -eq 0 ] || cat err
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
