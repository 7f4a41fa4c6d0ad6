#!/bin/sh
# The programs of docs/embedding.md: as they stand there, they compile without a warning and do what they say.
# Usage: BUILD_DIR=build CC=cc tests/viewer/examples.sh. Ends with "N passed, N failed".
set -u
cd "$(dirname "$0")/../.." || exit 1
build=${BUILD_DIR:-$PWD/build}
CC=${CC:-cc}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

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

# compile NAME FLAGS...
compile() {
    program=$1
    shift
    $CC -std=c99 -D_POSIX_C_SOURCE=200809L -Wall -Wextra -Wpedantic -Wshadow -Werror -Ilib/include \
        "docs/examples/$program.c" -L"$build/lib" -lpovtrace -lm "-Wl,-rpath,$build/lib" "$@" -o "$work/$program"
}

# printed NAME: is docs/examples/NAME.c in docs/embedding.md, line for line?
printed() {
    awk -v first="$(head -n 1 "docs/examples/$1.c")" '
        /^```/ { inside = 0 }
        $0 == first { inside = 1 }
        inside' docs/embedding.md | cmp -s - "docs/examples/$1.c"
}

check "batch.c is printed as it is" printed batch
check "batch.c compiles" compile batch
"$build/bin/povc" -q scenes/gallery/machine.pov 80 60 "$work/povc.png"
"$work/batch" scenes/gallery/machine.pov 80 60 "$work/batch.png"
check "its picture is povc's" cmp -s "$work/povc.png" "$work/batch.png"
echo 'spere { 0, 1 }' > "$work/wrong.pov"
"$work/batch" "$work/wrong.pov" 80 60 "$work/wrong.png" 2> "$work/err"
check "a wrong scene is an error" test $? -eq 1
check "with its place" grep -q 'wrong\.pov:1:1: ' "$work/err"
check "and no file" test ! -e "$work/wrong.png"

check "window.c is printed as it is" printed window
if pkg-config --exists glfw3; then
    check "window.c compiles" compile window $(pkg-config --cflags --libs glfw3)
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
