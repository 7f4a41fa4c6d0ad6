#!/bin/sh
# Pictures by a build for aarch64, run by qemu, against this machine's. BUILD_DIR names this machine's build; the other
# one, which `make aarch64` makes, is beside it.
. "$(dirname "$0")/../support/cases.sh"

other=$BUILD_DIR-aarch64
qemu=qemu-aarch64
# Debian's cross compiler has its C library here.
AARCH64_ROOT=${AARCH64_ROOT:-/usr/aarch64-linux-gnu}

aarch64_draws_every_scene_of_the_tests_bit_for_bit() {
    [ -x "$other/bin/povc" ] || skip "there is no aarch64-linux-gnu-gcc to build it with"
    command -v "$qemu" > qemu || skip "there is no $qemu to run it"
    for scene in "$root"/scenes/test/*.pov; do
        # Plugins that need a library are not built where only this machine has it.
        "$qemu" -L "$AARCH64_ROOT" "$other/bin/povc" "$scene" 32 24 there.pfm -q 2> log ||
            { grep -q 'no plugin' log && continue; cat log; fail "$scene"; }
        expect 0 "$povc" "$scene" 32 24 here.pfm -q
        cmp here.pfm there.pfm || echo "$scene" >> differ
    done
    [ ! -e differ ] || fail "$(cat differ)"
}

run_cases_of "$0" aarch64
end_cases
