# povtrace's own include files, beside POV-Ray's where they are installed.

own_includes=$root/share/povtrace/include
povrays_includes=/usr/share/povray-3.7/include

# names KIND FILE...: what the files declare, but for the words that keep them from being read twice.
names() {
    sed -n 's/^#declare \([A-Za-z0-9_]*\) = '"$1"'.*/\1/p' "$2" | grep -vi '_temp$'
}

# Colours and constants by name, and samples of the rest.
sample_scene() {
    cat "$root/tests/cli/includes.pov"
    names rgb "$own_includes/colors.inc" | sed 's/.*/String("&") Components(&)/'
    names '[-0-9]' "$own_includes/consts.inc" | sed 's/.*/String("&") Number(&)/'
    names '<' "$own_includes/consts.inc" | sed 's/.*/String("&") Vector(&)/'
}

includes_are_found_below_the_library() {
    echo "#include \"$BUILD_DIR/lib/../share/povtrace/include/colors.inc\" #debug str(Gray50.red, 0, 2)" > s.pov
    expect 0 "$povc" --check s.pov
    says err 0.50
}

includes_can_be_read_twice_and_in_any_order() {
    for file in "$own_includes"/*.inc; do
        name=$(basename "$file")
        printf '#include "%s"\n#include "%s"\n#include "%s"\n' "$name" "$name" math.inc > s.pov
        expect 0 "$povc" --check -L "$own_includes" s.pov
    done
}

includes_give_what_povrays_give() {
    [ -e "$povrays_includes/colors.inc" ] || skip "POV-Ray's include files are not installed"
    sample_scene > s.pov
    expect 0 "$povc" --check -L "$own_includes" s.pov
    grep '^= ' err > own
    expect 0 "$povc" --check -L "$povrays_includes" s.pov
    grep '^= ' err > povrays
    [ "$(grep -c . own)" -gt 500 ]
    diff own povrays
}

includes_fonts_are_found_without_their_ending() {
    [ -e "$povrays_includes/cyrvetic.ttf" ] || skip "POV-Ray's fonts are not installed"
    [ -e "$BUILD_DIR/lib/povtrace/primitives/text.so" ] || skip "text was not built: FreeType is missing"
    for font in cyrvetic cyrvetic.ttf; do
        echo "#declare T = text { ttf \"$font\" \"a\" 1, 0 } #debug str(max_extent(T).x, 0, 4)" > "$font.pov"
        expect 0 "$povc" --check "$font.pov"
        grep -v : err > "$font.said"
    done
    [ -s cyrvetic.said ]
    cmp cyrvetic.said cyrvetic.ttf.said
}

includes_outside_of_the_folders_are_named_as_such() {
    mkdir scenes elsewhere
    echo '#debug "read"' > elsewhere/part.inc
    echo '#include "../elsewhere/part.inc"' > scenes/s.pov
    cd scenes
    expect 1 "$povc" --check s.pov
    says err '"../elsewhere/part.inc" is outside of the folders that scenes are read from; -L FOLDER'
    expect 0 "$povc" --check -L ../elsewhere s.pov
    says err read
}
