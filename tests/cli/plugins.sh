# Plugins that are not there, or not what they should be: a clear error, and never a crash.

# The build's plugins, to be spoilt one by one; without those for wider processors, which would take their places.
copy_plugins() {
    mkdir -p path
    cp -R "$BUILD_DIR/lib/povtrace/primitives" "$BUILD_DIR/lib/povtrace/images" path/
    rm -rf path/primitives/*/
    chmod -R u+w path
}

# build_plugin FILE: a shared object from the C text on standard input.
build_plugin() {
    cat > plugin.c
    "$CC" -std=c99 -shared -fPIC -fvisibility=hidden -I"$root/lib/include" plugin.c -o "$1"
}

plugins_that_are_missing_are_named_with_the_folders_tried() {
    small_scene
    copy_plugins
    rm path/primitives/sphere.so
    POVTRACE_PLUGIN_PATH=path:elsewhere expect 1 "$povc" small.pov 8 8 out.png
    grep -qE '^small\.pov:3:1: error: ' err
    says err "sphere"
    says err "path:elsewhere"
    POVTRACE_PLUGIN_PATH=nowhere expect 1 "$povc" --check small.pov
    says err "nowhere"
    POVTRACE_PLUGIN_PATH=path:elsewhere expect 0 "$povc" small.pov 8 8 in.png --plugin-path "$BUILD_DIR/lib/povtrace"
    POVTRACE_PLUGIN_PATH=nowhere expect 1 "$povc" small.pov 8 8 out.png
    says err "png"
    says err "nowhere"
    [ ! -e out.png ]
}

# In front: what is not there is found in the usual place.
plugins_of_a_given_path_stand_in_front() {
    small_scene
    mkdir -p path/primitives
    expect 0 "$povc" small.pov 8 8 usual.png --plugin-path path:elsewhere
    build_plugin path/primitives/sphere.so <<'END'
int nothing;
END
    expect 1 "$povc" small.pov 8 8 out.png --plugin-path path
    says err "path/primitives/sphere.so"
}

plugins_of_another_contract_are_refused() {
    small_scene
    copy_plugins
    build_plugin path/primitives/sphere.so <<'END'
#include <povtrace/shape.h>
static const pov_shape_class *const shapes[] = { NULL };
POV_PLUGIN(sphere) = { .abi = POV_PLUGIN_ABI + 1, .size = sizeof(pov_plugin), .name = "sphere", .version = "9",
                       .shapes = shapes };
END
    expect 1 "$povc" --check small.pov --plugin-path path
    says err "path/primitives/sphere.so"
    says err "another version"
}

plugins_without_the_symbol_are_refused() {
    small_scene
    copy_plugins
    build_plugin path/primitives/sphere.so <<'END'
extern const int something_else;
__attribute__((visibility("default"))) const int something_else = 1;
END
    expect 1 "$povc" --check small.pov --plugin-path path
    says err "path/primitives/sphere.so"
    says err "povtrace_plugin"
}

plugins_that_offer_another_word_are_refused() {
    small_scene
    copy_plugins
    cp path/images/ppm.so path/primitives/sphere.so
    expect 1 "$povc" --check small.pov --plugin-path path
    says err "path/primitives/sphere.so"
    says err "sphere"
}

plugins_that_are_truncated_or_no_objects_at_all_are_refused() {
    small_scene
    copy_plugins
    whole=$BUILD_DIR/lib/povtrace/primitives/sphere.so
    size=$(wc -c < "$whole")
    for part in 0 1 40 64 600 4096; do
        head -c "$part" "$whole" > path/primitives/sphere.so
        expect 1 "$povc" --check small.pov --plugin-path path
        says err "path/primitives/sphere.so"
    done
    # What is loaded may be whole where only the tables for debuggers are cut off; but nothing may crash.
    for part in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15; do
        head -c $((size * part / 16)) "$whole" > path/primitives/sphere.so
        status=0
        "$povc" --check small.pov --plugin-path path > out 2> err || status=$?
        [ "$status" -le 1 ] || fail "exit status $status at $part/16 of the file"
    done
    echo "not an object" > path/primitives/sphere.so
    expect 1 "$povc" --check small.pov --plugin-path path
    says err "path/primitives/sphere.so"
    head -c 3000 "$BUILD_DIR/lib/povtrace/images/png.so" > path/images/png.so
    expect 1 "$povc" small.pov 8 8 out.png --plugin-path path
    says err "path/images/png.so"
}

plugins_are_loaded_only_when_the_scene_or_the_output_names_them() {
    small_scene
    copy_plugins
    find path -name '*.so' ! -name sphere.so ! -name ppm.so -exec sh -c ': > "$1"' sh {} \;
    expect 0 "$povc" small.pov 8 8 out.ppm --plugin-path path --stats
    grep -qxE 'plugins: (sphere,ppm|ppm,sphere)' out
    says out "plugins_loaded: 2"
}

plugins_are_not_looked_for_in_the_working_folder() {
    small_scene
    copy_plugins
    mkdir -p primitives images povtrace
    for folder in . povtrace; do
        mkdir -p "$folder/primitives"
        echo "not an object" > "$folder/primitives/sphere.so"
    done
    expect 0 "$povc" --check small.pov
}
