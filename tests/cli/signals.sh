# Signals: what is there is saved. The picture of these cases would take hours.

endless="--spp 65536 --preview 16 -t 2"

# ended SIGNAL STATUS: the signal ends povc with that status and a saved picture of the right size.
ended() {
    rich_scene
    rm -f out.png
    # shellcheck disable=SC2086
    "$PYTHON" "$drive" wait:0.5 running "$1" -- "$povc" rich.pov 640 480 out.png $endless > status 2> err
    [ "$(cat status)" -eq "$2" ] || fail "status $(cat status) instead of $2"
    [ "$("$PYTHON" "$pixels" size out.png)" = "640 480 8" ]
    says err "interrupted: out.png holds "
    grep -qE 'holds [0-9.]+ (of 65536 samples a pixel|% of the picture)' err || fail "$(cat err)"
}

signals_defect_11_save_the_picture_and_end_as_signals_do() {
    ended INT 130
    ended TERM 143
    ended HUP 129
}

signals_usr1_writes_the_picture_so_far_and_goes_on() {
    rich_scene
    # shellcheck disable=SC2086
    "$PYTHON" "$drive" wait:0.4 USR1 file:out.png gone:out.png running USR1 file:out.png running KILL -- \
        "$povc" rich.pov 640 480 out.png $endless > status 2> err
    [ "$(cat status)" -eq 137 ]
    [ "$("$PYTHON" "$pixels" size out.png)" = "640 480 8" ]
    says err "out.png now holds the picture so far"
}

signals_the_second_one_ends_at_once() {
    rich_scene
    # Somebody has the pipe open and does not read, so saving the picture never ends.
    mkfifo out.pfm
    sleep 20 < out.pfm & reader=$!
    # shellcheck disable=SC2086
    "$PYTHON" "$drive" wait:0.4 INT wait:0.5 running INT -- "$povc" rich.pov 640 480 out.pfm $endless > status
    kill "$reader"
    [ "$(cat status)" -eq 130 ]
}

signals_that_were_ignored_stay_ignored() {
    rich_scene
    # shellcheck disable=SC2086
    "$PYTHON" "$drive" ignore:INT wait:0.4 INT wait:0.5 running TERM -- "$povc" rich.pov 640 480 out.png $endless \
        > status 2> err
    [ "$(cat status)" -eq 143 ]
}

signals_save_to_standard_output_too() {
    rich_scene
    # shellcheck disable=SC2086
    "$PYTHON" "$drive" wait:0.5 TERM -- sh -c 'exec "$@" > pipe.png' sh "$povc" rich.pov 640 480 - $endless > status 2> err
    [ "$(cat status)" -eq 143 ]
    [ "$("$PYTHON" "$pixels" size pipe.png)" = "640 480 8" ]
}

signals_without_a_preview_keep_what_was_traced_equal_to_the_whole() {
    rich_scene
    expect 0 "$povc" rich.pov 320 240 whole.ppm
    "$PYTHON" "$drive" wait:0.05 TERM -- "$povc" rich.pov 320 240 part.ppm -t 1 > status 2> err
    [ -e part.ppm ] || skip "it ended before the job began"
    "$PYTHON" - <<'END'
whole, part = open("whole.ppm", "rb").read(), open("part.ppm", "rb").read()
assert len(whole) == len(part)
pixels = [(whole[i:i + 3], part[i:i + 3]) for i in range(len(whole) - 320 * 240 * 3, len(whole), 3)]
wrong = sum(a != b and b != b"\0\0\0" for a, b in pixels)
assert wrong == 0, "%d pixels are neither black nor the picture's" % wrong
END
}
