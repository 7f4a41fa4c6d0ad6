# A picture in parts that other processes trace, and the same bits as in one.

trace_parts() {   # trace_parts NUMBER OPTION...: all of them, in an order of no meaning, with threads that differ
    number=$1
    shift
    for i in $(seq "$number" -1 1); do
        expect 0 "$povc" rich.pov 75 50 out.png -t $((i % 3 + 1)) --part "$i/$number" "$@"
    done
}

# join_rounds COMMAND...: join until the picture is complete; the command traces the parts of another round.
join_rounds() {
    rounds=1
    while :; do
        actual=0
        "$povc" --merge out.png 2> err || actual=$?
        [ "$actual" -eq 4 ] || break
        rounds=$((rounds + 1))
        "$@"
    done
    [ "$actual" -eq 0 ] || fail "--merge ends with $actual: $(cat err)"
}

parts_make_the_bits_of_one_picture() {
    rich_scene
    while read -r options; do
        # shellcheck disable=SC2086
        expect 0 "$povc" rich.pov 75 50 one.png $options
        # shellcheck disable=SC2086
        trace_parts 5 $options
        # shellcheck disable=SC2086
        join_rounds trace_parts 5 $options
        same one.png out.png
        [ "$(echo out.png*)" = out.png ] || fail "the parts are still there: $(echo out.png*)"
    done <<'END'
-q
-q --spp 9 --bits 16
-q --spp 5 --alpha --crop 10,5,60,47 --transfer linear
-q --error 0.02 --sampling uniform
END
}

parts_go_on_in_rounds_where_the_whole_picture_decides() {
    rich_scene
    expect 0 "$povc" rich.pov 75 50 one.png -q --error .008 --bits 16
    trace_parts 3 --error .008 --bits 16
    expect 4 "$povc" --merge out.png
    says err "round 1: 4.0 samples a pixel"
    [ -s out.png.round ] || fail "the next round is not written down"
    # Joined again, it is the same round; and a part that was lost is traced anew.
    cp out.png.round kept
    expect 4 "$povc" --merge out.png
    same out.png.round kept
    rm out.png.part-2-of-3
    trace_parts 3 --error .008 --bits 16
    join_rounds trace_parts 3 --error .008 --bits 16
    [ "$rounds" -gt 1 ] || fail "$rounds rounds"
    says err "joined after round $((rounds + 1))"
    same one.png out.png
    [ "$(echo out.png*)" = out.png ] || fail "the parts are still there: $(echo out.png*)"
}

parts_of_a_limit_that_is_not_reached_say_so() {
    rich_scene
    expect 3 "$povc" rich.pov 75 50 one.png --error 1e-6 --spp 6
    trace_parts 2 --error 1e-6 --spp 6
    expect 4 "$povc" --merge out.png
    trace_parts 2 --error 1e-6 --spp 6
    expect 3 "$povc" --merge out.png
    says err "target error not reached"
    same one.png out.png
}

parts_may_be_more_than_the_tiles() {
    rich_scene
    expect 0 "$povc" rich.pov 20 12 one.png
    for i in 1 2 3 4 5 6 7; do
        expect 0 "$povc" rich.pov 20 12 out.png --part "$i/7" -q
    done
    expect 0 "$povc" --merge out.png
    same one.png out.png
}

parts_that_are_missing_or_damaged_are_named() {
    rich_scene
    expect 1 "$povc" --merge out.png
    says err "there are no parts of this picture"
    trace_parts 9 -q --spp 2
    cp out.png.part-4-of-9 kept
    rm out.png.part-2-of-9 out.png.part-7-of-9 out.png.part-8-of-9
    head -c 3000 kept > out.png.part-4-of-9
    expect 1 "$povc" --merge out.png
    says err "out.png.part-4-of-9 is damaged"
    says err "to be traced: 2, 4, 7-8 of 9"
    [ ! -e out.png ] || fail "there is a picture"
    [ "$(ls out.png.part-* | wc -l)" -eq 6 ] || fail "parts were lost"
    for i in 2 4 7 8; do
        expect 0 "$povc" rich.pov 75 50 out.png -q --spp 2 --part "$i/9"
    done
    # One byte of one pixel.
    cp out.png.part-5-of-9 kept
    printf 'x' | dd of=out.png.part-5-of-9 bs=1 seek=2000 conv=notrunc 2> /dev/null
    expect 1 "$povc" --merge out.png
    says err "to be traced: 5 of 9"
    cp kept out.png.part-5-of-9
    expect 0 "$povc" --merge out.png
}

parts_of_another_picture_are_refused() {
    rich_scene
    sed 's/angle 50/angle 51/' rich.pov > other.pov
    trace_parts 3 -q
    for options in 'other.pov 75 50' 'rich.pov 75 50 --spp 2' 'rich.pov 75 50 --bits 16' 'rich.pov 75 50 --max-depth 2' 'rich.pov 75 50 -D A=1'; do
        # shellcheck disable=SC2086
        expect 0 "$povc" $options -o out.png --part 2/3
        expect 1 "$povc" --merge out.png
        says err "out.png.part-2-of-3 is of another scene, or was made with other options"
        says err "to be traced: 2 of 3"
    done
    expect 0 "$povc" rich.pov 75 50 out.png --part 2/4
    expect 2 "$povc" --merge out.png
    says err "remove those that are not meant"
    # What an aborted render left behind.
    rm out.png.part-*
    trace_parts 2 --error .01
    expect 4 "$povc" --merge out.png
    expect 2 "$povc" other.pov 75 50 out.png --error .01 --part 1/2
    says err "another scene text"
    says err "remove out.png.round to begin anew"
}

parts_are_whole_or_not_there() {
    rich_scene
    for pause in 0.02 0.1 0.3; do
        "$povc" rich.pov 640 480 out.png -q --spp 64 --part 1/2 2> /dev/null &
        running=$!
        sleep "$pause"
        kill -9 "$running" 2> /dev/null || true
        wait "$running" 2> /dev/null || true
        [ ! -e out.png.part-1-of-2 ] || fail "a part of a part"
    done
    "$povc" rich.pov 640 480 out.png --spp 64 --part 1/2 2> err &
    running=$!
    sleep 0.3
    kill "$running"
    actual=0
    wait "$running" || actual=$?
    [ "$actual" -eq 143 ] || fail "ended by $actual"
    says err "part 1 of 2 is not written"
    [ "$(echo out.png*)" = 'out.png*' ] || fail "something was written: $(echo out.png*)"
}

parts_refuse_what_they_cannot_keep() {
    rich_scene
    for options in '--part 0/3' '--part 4/3' '--part 3' '--part x/3' '--part 1/3 --time 2' '--part 1/3 --resume' '--part 1/3 --preview 4' \
        '--part 1/3 --report a.csv' '--part 1/3 --aov depth d.pfm'; do
        # shellcheck disable=SC2086
        expect 2 "$povc" rich.pov 75 50 out.png $options
        says err "--part"
    done
    expect 2 "$povc" rich.pov 75 50 - --part 1/3
    expect 2 "$povc" --merge
    expect 2 "$povc" --merge rich.pov 75 50 out.png
}

parts_run_by_gnu_parallel() {
    command -v parallel > /dev/null || skip "no GNU parallel here"
    rich_scene
    expect 0 "$povc" rich.pov 75 50 one.png -q --error .01
    PATH=$BUILD_DIR/bin:$PATH
    export PATH
    expect 0 sh "$root/docs/examples/parallel.sh" rich.pov 75 50 out.png 6 --error .01
    same one.png out.png
}
