# The copies of the library for wider processors, beside the baseline.

wide_folder=$BUILD_DIR/lib/glibc-hwcaps

# Sets `copies` to those that this processor can run, the widest first.
needs_wide() {
    [ -d "$wide_folder" ] || skip "this build has no wider copy"
    loader=$(ldd "$povc" | awk '$1 ~ /ld-linux/ { print $1 }')
    [ -n "$loader" ] || skip "the loader has another name here"
    copies=
    for copy in $("$loader" --help | awk '/x86-64-v[0-9] \(supported/ { print $1 }'); do
        [ ! -d "$wide_folder/$copy" ] || copies="$copies $copy"
    done
    [ -n "$copies" ] || skip "this processor runs the baseline only"
}

# povc with one of the copies.
with_copy() {
    copy=$1
    shift
    LD_LIBRARY_PATH=$wide_folder/$copy "$povc" "$@"
}

# povc with the baseline, whatever the processor.
baseline() {
    LD_LIBRARY_PATH=$cases_folder/narrow "$povc" "$@"
}

# A folder that the loader looks into first, with the baseline and nothing else.
make_narrow() {
    mkdir -p "$cases_folder/narrow"
    ln -sf "$BUILD_DIR/lib/libpovtrace.so.0" "$cases_folder/narrow/"
}

wide_library_and_plugins_are_taken_where_the_processor_has_what_they_need() {
    needs_wide
    widest=${copies# }
    widest=${widest%% *}
    small_scene
    expect 0 "$povc" --version
    says out ", $widest)"
    expect 0 "$povc" small.pov 8 6 out.ppm --stats
    says out "built_for: $widest"
    expect 0 "$povc" --explain small.pov
    says out "$widest"
    LD_DEBUG=files "$povc" --check small.pov > trace 2>&1
    says trace "primitives/$widest/sphere.so"
    make_narrow
    expect 0 baseline --version
    says out ", baseline)"
    LD_DEBUG=files LD_LIBRARY_PATH=$cases_folder/narrow "$povc" --check small.pov > trace 2>&1
    says trace "primitives/sphere.so"
    says_not trace "$widest/sphere.so"
}

wide_pictures_are_the_baselines_bit_for_bit() {
    needs_wide
    make_narrow
    for scene in "$root"/scenes/test/*.pov "$root"/scenes/gallery/*.pov; do
        expect 0 baseline "$scene" 64 48 narrow.pfm -q
        for copy in $copies; do
            expect 0 with_copy "$copy" "$scene" 64 48 wide.pfm -q
            cmp wide.pfm narrow.pfm || fail "$scene by $copy"
        done
    done
}

wide_plugins_are_no_need() {
    needs_wide
    small_scene
    printf 'box { <-1, -1, -1>, <1, 1, 1> }\n' >> small.pov
    for copy in $copies; do
        mkdir -p "$copy/primitives/$copy"
        cp "$BUILD_DIR/lib/povtrace/primitives/sphere.so" "$copy/primitives/"
        cp "$BUILD_DIR/lib/povtrace/primitives/$copy/box.so" "$copy/primitives/$copy/"
        expect 0 with_copy "$copy" --check small.pov --plugin-path "$copy"
    done
}

# `make bench-bits` does so with larger pictures, more threads and a build of portable C alone.
wide_and_narrow_trees_and_lists_draw_the_benchs_scenes_alike() {
    expect 0 "$PYTHON" "$root/tests/bench/bits.py" --povc "$povc" --work bits --size 40x30 --threads 1 3
    says out ": 0 differ"
}
