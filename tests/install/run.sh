#!/bin/sh
# The installed tree, as other programs meet it. BUILD_DIR names the build; it is installed below a temporary folder.
. "$(dirname "$0")/../support/cases.sh"

here=$root/tests/install
stage=$cases_folder/stage
prefix=/usr/local
lib=$stage$prefix/lib
PKG_CONFIG=${PKG_CONFIG:-pkg-config}

# make_tree TARGET WORDS...
make_tree() {
    make -s -C "$root" BUILD="$BUILD_DIR" CC="$CC" DESTDIR="$stage" PREFIX="$prefix" MAKEFLAGS= "$@"
}

# The flags a stranger gets; the staging folder stands before each path.
flags() {
    PKG_CONFIG_SYSROOT_DIR=$stage PKG_CONFIG_LIBDIR=$lib/pkgconfig "$PKG_CONFIG" "$@" povtrace
}

strict='-Wall -Wextra -Wpedantic -Werror'

install_puts_every_file_in_its_place() {
    make_tree install
    for file in bin/povc lib/libpovtrace.so lib/libpovtrace.so.0 lib/libpovtrace.so.0.1.0 lib/libpovtrace.a \
        lib/pkgconfig/povtrace.pc lib/cmake/povtrace/povtraceConfig.cmake lib/cmake/povtrace/povtraceConfigVersion.cmake \
        lib/povtrace/primitives/sphere.so lib/povtrace/images/png.so include/povtrace/povtrace.h \
        include/povtrace/plugin.h include/povtrace/exact.h share/man/man1/povc.1 share/man/man3/povtrace.3 \
        share/bash-completion/completions/povc share/zsh/site-functions/_povc share/fish/vendor_completions.d/povc.fish \
        share/doc/povtrace/README.md share/doc/povtrace/docs/embedding.md share/doc/povtrace/scenes/gallery/pool.pov \
        share/povtrace/include/colors.inc; do
        [ -s "$stage$prefix/$file" ] || fail "no $file"
    done
    [ "$(readlink "$lib/libpovtrace.so.0")" = libpovtrace.so.0.1.0 ]
    [ "$(readlink "$lib/libpovtrace.so")" = libpovtrace.so.0 ]
    [ "$(ls "$lib/povtrace/primitives" | grep -c '\.so$')" -eq "$(ls "$root"/plugins/primitives/*.c | wc -l)" ]
    if grep -r '@[A-Z_]*@' "$lib/pkgconfig" "$lib/cmake"; then
        fail "something was not filled in"
    fi
}

install_puts_the_wider_copies_where_the_loader_looks() {
    [ -d "$BUILD_DIR/lib/glibc-hwcaps" ] || skip "this build has no wider copies"
    for copy in $(ls "$BUILD_DIR/lib/glibc-hwcaps"); do
        [ "$(readlink "$lib/glibc-hwcaps/$copy/libpovtrace.so.0")" = libpovtrace.so.0.1.0 ] || fail "$copy"
        [ -s "$lib/glibc-hwcaps/$copy/libpovtrace.so.0.1.0" ] || fail "$copy"
        [ "$(ls "$lib/povtrace/primitives/$copy")" = "$(cd "$lib/povtrace/primitives" && ls -- *.so)" ] || fail "$copy"
    done
}

install_defect_9_the_demo_names_the_viewer() {
    make_tree -n demo > out
    says out "$BUILD_DIR/bin/povview scenes/gallery/"
}

install_defect_10_the_build_says_a_short_line_for_each_file() {
    make -C "$root" BUILD="$PWD/small" CC="$CC" MAKEFLAGS= "$PWD/small/obj/lib/base/arena.o" > out
    grep -qE '^CC +lib/base/arena.c *$' out || fail "$(cat out)"
    awk 'length > 100 { exit 1 }' out
}

install_defect_27_the_help_names_the_viewer() {
    make_tree help > out
    says out "bin/povview"
    [ ! -x "$BUILD_DIR/bin/povview" ] || [ -s "$stage$prefix/share/bash-completion/completions/povview" ]
}

# A file that no package takes ends the build of them all, after minutes.
install_debian_packages_take_every_file() {
    mkdir -p tree/usr/lib/triplet
    cp -R "$stage$prefix"/. tree/usr
    mv tree/usr/lib/[!t]* tree/usr/lib/triplet
    {
        cat "$root"/debian/*.install "$root/debian/not-installed"
        sed -n 's/.*dh_install -p[a-z0-9]* //p' "$root/debian/rules"
    } | while read -r files; do
        # shellcheck disable=SC2086
        (cd tree && rm -r $files) || [ "$files" = usr/lib/python3 ] || fail "debian: no $files"
    done
    [ -z "$(find tree ! -type d)" ] || fail "no Debian package takes $(find tree ! -type d)"
}

install_povc_finds_its_library_and_plugins_wherever_the_tree_stands() {
    cp -R "$stage$prefix" moved
    "$povc" --version > built
    expect 0 moved/bin/povc --version
    same out built
    printf 'sphere { <0, 0, 5>, 2 pigment { color rgb <1, 1, 1> } finish { ambient 1 } }\n' > small.pov
    expect 0 moved/bin/povc small.pov 8 6 out.png --stats
    says out "plugins_loaded: 2"
    [ -s out.png ]
}

install_a_c_program_builds_by_pkg_config_and_runs() {
    # shellcheck disable=SC2046,SC2086
    "$CC" -std=c99 $strict "$here/client.c" $(flags --cflags --libs) -o client
    expect 0 env LD_LIBRARY_PATH="$lib" ./client out.png
    says out "hit 0 at 1.5"
    [ "$("$PYTHON" "$root/tests/cli/pixels.py" size out.png)" = "32 24 8" ]
    [ "$(flags --modversion)" = 0.1.0 ]
}

install_a_c_program_builds_statically_and_finds_the_plugins() {
    # shellcheck disable=SC2046,SC2086
    "$CC" -std=c99 $strict "$here/client.c" $(flags --cflags) "$lib/libpovtrace.a" -lm -ldl -lpthread -o client
    expect 0 env POVTRACE_PLUGIN_PATH="$lib/povtrace" ./client out.png
    [ -s out.png ]
    if ldd ./client | grep povtrace; then
        fail "it is linked to the shared library"
    fi
}

install_defect_25_a_cpp_program_builds_by_pkg_config_and_runs() {
    # shellcheck disable=SC2046,SC2086
    "$CXX" -std=c++11 $strict "$here/client.cpp" $(flags --cflags --libs) -o client
    expect 0 env LD_LIBRARY_PATH="$lib" ./client
    says out "hit at 3"
}

install_a_python_program_runs_by_ctypes() {
    expect 0 "$PYTHON" "$here/client.py" "$lib/libpovtrace.so.0"
    says out "libpovtrace 0.1.0"
    says out "hit at 3.0"
}

install_a_cmake_project_finds_the_package() {
    command -v cmake > /dev/null || skip "there is no cmake"
    cp "$here/CMakeLists.txt" "$here/client.c" .
    cmake -S . -B build -DCMAKE_PREFIX_PATH="$stage$prefix" > log
    cmake --build build >> log
    expect 0 build/shared_client shared.png
    expect 0 env POVTRACE_PLUGIN_PATH="$lib/povtrace" build/static_client static.png
    same shared.png static.png
    sed -i.old 's/povtrace 0\.1/povtrace 0.2/' CMakeLists.txt
    if cmake -S . -B build2 -DCMAKE_PREFIX_PATH="$stage$prefix" > log 2>&1; then
        fail "version 0.2 was asked for and 0.1 found"
    fi
}

install_the_manuals_example_compiles() {
    awk '/^int main/ || /^#include/ { on = 1 } on && /^\.fi/ { exit } on { print }' "$root/docs/man/povtrace.3" |
        awk '/^\.B/ { next } { gsub(/\\e/, "\\"); gsub(/\\-/, "-"); print }' > example.c
    # shellcheck disable=SC2046,SC2086
    "$CC" -std=c99 $strict example.c $(flags --cflags --libs) -o example
    printf 'sphere { <0, 0, 0>, 1 }\n' > scene.pov
    expect 0 env LD_LIBRARY_PATH="$lib" ./example
    says out "object 0 at distance 9"
}

install_the_manual_names_every_call_there_is() {
    while read -r call; do
        says "$root/docs/man/povtrace.3" "$call"
    done < "$root/tests/api/exports.txt"
}

install_the_disc_plugin_builds_out_of_tree_and_loads_by_path() {
    # shellcheck disable=SC2046,SC2086
    "$CC" -std=c99 $strict -O2 -ffp-contract=off -shared -fPIC -fvisibility=hidden \
        "$root/tests/plugins/out_of_tree/disc.c" $(flags --cflags) -lm -o disc.so
    mkdir -p mine/primitives
    mv disc.so mine/primitives/
    printf 'camera { location <0, 0, -5> look_at <0, 0, 0> }\n' > disc.pov
    printf 'disc { <0, 0, 0>, <0, 0, 1>, 1.5, .5 pigment { color rgb <1, 1, 1> } finish { ambient 1 } }\n' >> disc.pov
    # It takes the place of the one that is installed.
    expect 0 "$stage$prefix/bin/povc" --check disc.pov
    expect 0 "$stage$prefix/bin/povc" disc.pov 40 30 out.ppm --plugin-path "mine:$lib/povtrace" --stats
    grep -qE '^plugins: .*disc' out
    # White where the disc is, black around it and in its hole.
    "$PYTHON" - <<'END'
data = open("out.ppm", "rb").read()[-40 * 30 * 3:]
at = lambda x, y: data[(y * 40 + x) * 3]
assert at(20, 15) == 0 and at(0, 0) == 0 and at(28, 15) == 255, (at(20, 15), at(0, 0), at(28, 15))
END
}

install_the_disc_plugin_is_added_by_a_program() {
    # shellcheck disable=SC2046,SC2086
    "$CC" -std=c99 -Wall -Wextra -O2 -ffp-contract=off "$here/disc_client.c" "$root/tests/plugins/out_of_tree/disc.c" \
        $(flags --cflags --libs) -lm -o disc_client
    expect 0 env LD_LIBRARY_PATH="$lib" ./disc_client
    says out 'disc from "": distance 5, hole'
}

install_exports_what_the_list_says_and_needs_libc_and_libm_only() {
    nm -D --defined-only "$lib/libpovtrace.so.0" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort > exports
    sort "$root/tests/api/exports.txt" | diff - exports
    nm "$BUILD_DIR/bin/povc" | grep -qE '__(asan|tsan|ubsan)' && skip "this build is instrumented"
    ldd "$lib/libpovtrace.so.0" | awk '{ print $1 }' > needs
    if grep -vE '^(linux-vdso|linux-gate|(/.*/)?ld-|lib(c|m|dl|pthread)\.so)' needs; then
        fail "it needs more"
    fi
}

install_names_its_own_version_only() {
    objdump -p "$lib/libpovtrace.so.0" > headers || skip "there is no objdump"
    grep -qE 'SONAME +libpovtrace\.so\.0$' headers
    if grep -E 'R(UN)?PATH' headers; then
        fail "the library looks for others by a path of its own"
    fi
    objdump -p "$stage$prefix/bin/povc" | grep -qE 'R(UN)?PATH +\$ORIGIN/\.\./lib$'
}

install_can_be_taken_away_again() {
    echo keep > "$stage$prefix/lib/of-somebody-else"
    make_tree uninstall
    find "$stage" ! -type d > left
    [ "$(cat left)" = "$stage$prefix/lib/of-somebody-else" ] || fail "left: $(cat left)"
    [ ! -e "$stage$prefix/include/povtrace" ]
    [ ! -e "$stage$prefix/lib/povtrace" ]
    [ ! -e "$stage$prefix/lib/glibc-hwcaps" ]
}

deps_installs_what_is_missing_and_nothing_else() {
    mkdir tools
    printf '#!/bin/sh\necho "$0 $*" >> calls\n' > tools/apt-get
    cp tools/apt-get tools/sudo
    # pkg-config that lacks libpng until it was installed.
    cat > tools/pkg-config <<'END'
#!/bin/sh
[ "$2" != libpng ] || grep -q libpng-dev calls 2> /dev/null
END
    chmod +x tools/*
    PATH=$PWD/tools:$PATH CI= CC=sh CXX=sh PYTHON=sh PKG_CONFIG=pkg-config expect 0 "$root/.ci/deps" test
    says out "libpng-dev"
    says calls "libpng-dev"
    says_not calls "cmocka"
    rm calls
    printf '#!/bin/sh\nexit 0\n' > tools/pkg-config
    PATH=$PWD/tools:$PATH CI= CC='env sh' CXX='env -i sh' PYTHON=sh PKG_CONFIG=pkg-config expect 0 "$root/.ci/deps" test
    [ ! -e calls ]
    [ ! -s out ]
}

# In the order of the file: the first case installs, the last one takes it away.
run_cases_of "$here/run.sh" install
run_cases_of "$here/run.sh" deps
end_cases
