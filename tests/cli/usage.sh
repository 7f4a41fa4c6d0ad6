# What povc makes of its command line.

usage_errors_end_in_2_and_say_where_help_is() {
    small_scene
    for line in '' 'small.pov 8' '8 8 small.pov o.png' 'small.pov -s 8 -o o.png' 'small.pov 8 8' 'small.pov 8 8 o.png more' 'small.pov 8x 8 o.png' \
        'small.pov 0 8 o.png' 'small.pov -5 8 o.png' 'small.pov 8 1e3 o.png' 'small.pov 99999999999999999999 8 o.png' \
        'small.pov 8 8 o.png --threads 0' 'small.pov 8 8 o.png --bits 9' 'small.pov 8 8 o.png --nonsense' \
        'small.pov 8 8 o.png --spp' 'small.pov 8 8 o.png --crop 0,0,9,8'; do
        # shellcheck disable=SC2086
        expect 2 "$povc" $line
        says err "povc: error:"
        says err "--help"
        [ ! -s out ]
    done
    [ ! -e o.png ]
}

usage_help_and_version_are_on_standard_output() {
    expect 0 "$povc" --help
    says out "povc SCENE WIDTH HEIGHT OUTPUT"
    [ ! -s err ]
    expect 0 "$povc" --version
    grep -qE '^povc [0-9]+\.[0-9]+\.[0-9]+ \(libpovtrace [0-9]+\.[0-9]+\.[0-9]+, (baseline|x86-64-v[0-9])\)$' out
}

usage_help_names_every_option_of_the_manual() {
    expect 0 "$povc" --help
    sed -n 's/^\.B[IR]* .*\\-\\-\([a-z\\-]*\).*/--\1/p' "$root/docs/man/povc.1" | tr -d "\\\\" | grep -v '^--$' | sort -u > manual
    [ "$(wc -l < manual)" -ge 15 ]
    while read -r option; do
        says out "$option"
        says "$root/cli/povc.bash" "$option"
        says "$root/docs/cli.md" "$option"
    done < manual
}

usage_output_that_cannot_be_written_is_an_error() {
    [ -w /dev/full ] || skip "there is no /dev/full"
    status=0
    "$povc" --help > /dev/full 2> err || status=$?
    [ "$status" -eq 1 ]
    says err "cannot write"
}

usage_a_wrong_ending_is_said_before_any_work() {
    expect 1 "$povc" no-such-scene.pov 8 8 out.gpj
    says err 'gpj'
    says_not err "no-such-scene"
    expect 2 "$povc" no-such-scene.pov 8 8 out
    says err "ending"
    [ ! -e out.gpj ]
}

usage_a_place_that_cannot_be_written_is_said_before_any_work() {
    mkdir folder.png
    expect 1 "$povc" no-such-scene.pov 8 8 folder.png
    says err "folder.png"
    expect 1 "$povc" no-such-scene.pov 8 8 no-such-folder/out.png
    says err "no-such-folder/out.png"
    says_not err "no-such-scene"
}

usage_options_may_stand_anywhere() {
    small_scene
    expect 0 "$povc" small.pov 9 7 a.ppm --spp 2 -t 1
    expect 0 "$povc" --spp=2 small.pov -t1 9 7 b.ppm
    same a.ppm b.ppm
}
