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
        says "$root/share/completions/povc.bash" "$option"
        for file in _povc povc.fish; do
            says "$root/share/completions/$file" "${option#--}"
        done
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

usage_defect_19_a_wrong_ending_is_said_before_any_work() {
    expect 2 "$povc" no-such-scene.pov 8 8 out.gpj
    says err '".gpj"; there are '
    says err 'png, ppm'
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

usage_defect_21_what_counts_for_less_than_it_seems_is_said() {
    small_scene
    expect 0 "$povc" small.pov 8 6 o.png --spp 2 --spp 3
    says err "warning: --spp is given twice"
    expect 0 "$povc" small.pov 8 6 a.png --format ppm
    says err "a.png holds ppm"
    expect 0 "$povc" small.pov 8 6 r.ppm
    expect 0 "$povc" small.pov 8 6 o.png --reference r.ppm
    says err "--reference counts for a --report only"
    expect 2 "$povc" small.pov 8 6 o.png --aov time a.png --aov time b.png
    says err "given twice"
    expect 0 "$povc" small.pov 8 6 o.png -q --spp 2 --spp 3
    [ ! -s err ]
}

usage_defect_7_a_plugin_path_stands_in_front() {
    small_scene
    mkdir mine
    expect 0 "$povc" small.pov 8 6 o.png --plugin-path mine
    [ -s o.png ]
}

usage_defect_30_lines_of_the_help_fit_a_terminal() {
    "$povc" --help > help
    awk 'length > 80 { print; wide = 1 } END { exit wide }' help
}

usage_defect_28_many_scenes_are_checked_at_once() {
    small_scene a.pov
    small_scene b.pov
    printf 'sphere { 0, 1 pigmnt { rgb 1 } }\n' > c.pov
    expect 1 "$povc" --check a.pov c.pov b.pov
    says out "a.pov: no errors"
    says out "b.pov: no errors"
    says err "c.pov:1:15: error:"
}
