#!/bin/sh
# The rules of the house that a machine can see. Prints "ok" or "not ok" for each; any "not ok" is a failure.
# Usage: BUILD=build CC=cc CXX=c++ tests/check/check.sh (after the library and the plugins are built)
set -u
cd "$(dirname "$0")/../.." || exit 1
BUILD=${BUILD:-build}
CC=${CC:-cc}
CXX=${CXX:-c++}
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
passed=0 failed=0

# report NAME: what stands in $work/found is what breaks the rule.
report() {
    if [ -s "$work/found" ]; then
        failed=$((failed + 1))
        echo "not ok $1"
        sed 's/^/    /' "$work/found"
    else
        passed=$((passed + 1))
        echo "ok $1"
    fi
    : > "$work/found"
}
: > "$work/found"

sources() { find "$@" \( -name "*.c" -o -name "*.h" \) 2>/dev/null | LC_ALL=C sort; }

# The C files without their comments, the lines where they were: "file:line:text".
without_comments() {
    awk '
        FNR == 1 { inside = 0 }
        {
            line = $0; out = ""
            while (line != "") {
                if (inside) {
                    end = index(line, "*/")
                    if (!end) { line = ""; break }
                    line = substr(line, end + 2); inside = 0
                } else {
                    start = index(line, "/*"); slashes = index(line, "//")
                    if (slashes && (!start || slashes < start)) { out = out substr(line, 1, slashes - 1); line = "" }
                    else if (start) { out = out substr(line, 1, start - 1); line = substr(line, start + 2); inside = 1 }
                    else { out = out line; line = "" }
                }
            }
            if (out != "") print FILENAME ":" FNR ":" out
        }' "$@"
}

# ---- rooms: which includes a folder's files may have ----

# room FOLDER PATTERN: quoted and <povtrace/...> includes must match the extended regular expression.
room() {
    [ -d "$1" ] || return 0
    for file in $(sources "$1"); do
        grep -nE '^[[:space:]]*#[[:space:]]*include' "$file" |
            sed -nE 's/^([0-9]+):[^"<]*("[^"]*"|<povtrace\/[^>]*>).*/\1 \2/p' |
            grep -vE "^[0-9]+ ($2)\$" | sed "s|^|$file:|" >> "$work/found"
    done
    report "$1 includes only what its room may"
}
public='<povtrace/[a-z_]+\.h>'
# All but the contract of plugins.
plain='<povtrace/(povtrace|base|build|math|exact|scene|trace|render|image|plot)\.h>'
room lib/include "$public"
# The rooms of lib, by the table of docs/internals.md: a room includes itself and the rooms of its row. The contract of
# plugins is for those whose row names one of its headers.
sed -n '/^| room |/,/^$/s/^| *`lib\/\([a-z]*\)` *|.*| *\([^|]*\) *|$/\1 \2/p' docs/internals.md > "$work/rooms"
while read -r name may; do
    rooms=$(echo "$may" | tr ',' '\n' | sed -n 's/^ *\([a-z]*\) *$/|\1/p' | tr -d '\n')
    headers=$plain
    case $name,$may in
    base,*) headers='<povtrace/(base|math|exact)\.h>' ;;
    *"every room") rooms='|[a-z]+' headers=$public ;;
    *.h*) headers=$public ;;
    esac
    room "lib/$name" "\"($name$rooms)/[a-z_0-9]+\.h\"|$headers"
done < "$work/rooms"
room plugins/primitives "\"common/[a-z_0-9]+\.h\"|<povtrace/(plugin|shape|shape_fast|base|math|exact)\.h>"
room plugins/images "\"common/[a-z_0-9]+\.h\"|<povtrace/(plugin|base|math|exact|image)\.h>"
room plugins/plots "\"common/[a-z_0-9]+\.h\"|<povtrace/(plugin|base|math|exact|image|plot)\.h>"
room plugins/common "\"(common/[a-z_0-9]+|base/elementary)\.h\"|<povtrace/(plugin|shape|shape_fast|base|math|exact)\.h>"
room cli "\"[a-z_]+\.h\"|$plain"
room viewer "\"[a-z_]+\.h\"|$plain"

# The table of rooms in docs/internals.md has a row for each folder, and no other.
sed -n '/^| room |/,/^$/s/^| *\(`[^|]*`\) *|.*/\1/p' docs/internals.md | tr -d '` ' | tr ',' '\n' | LC_ALL=C sort > "$work/rows"
git ls-files 2>/dev/null | sed -nE 's#^(lib/include/povtrace|(lib|plugins)/[a-z]+|cli|viewer|tests|scenes)/.*#\1#p' |
    grep -vx lib/include | LC_ALL=C sort -u > "$work/folders"
[ ! -s "$work/folders" ] || diff "$work/rows" "$work/folders" | sed -n 's/^</no such folder:/p; s/^>/no row:/p' > "$work/found"
report "the table of rooms in docs/internals.md names the folders there are"

for file in $(sources lib plugins cli viewer tests); do
    grep -nE '^[[:space:]]*#[[:space:]]*include[^"<]*"[^"]*\.\./' "$file" | sed "s|^|$file:|" >> "$work/found"
done
report "no include climbs with .."

sources plugins/primitives plugins/images | xargs grep -lE '#[[:space:]]*include[[:space:]]*<png' |
    grep -v '^plugins/images/png\.c$' >> "$work/found"
report "only png.c includes libpng"

# ---- words and literals ----

sources lib plugins cli viewer tests | xargs grep -nE '(^|[^A-Z])(TODO|FIXME|XXX)([^A-Z]|$)' >> "$work/found"
report "no TODO, FIXME or XXX"

# Small powers of ten smell of an absolute tolerance. Those that are none stand in literals.txt, with what they are.
without_comments $(sources lib plugins) > "$work/code"
grep -nE '[^0-9a-zA-Z_.][0-9.]+[eE]-(0?[3-9]|1[0-5])[^0-9]|[^0-9.]0?\.00+1[^0-9]' "$work/code" |
    cut -d: -f2- | sed 's/:[0-9]*: */: /' | grep -vxFf tests/check/literals.txt >> "$work/found"
report "no literal of lib or plugins smells of an absolute epsilon"

grep -E '(^|[^a-zA-Z0-9_.>])(malloc|calloc|realloc|free|strdup|posix_memalign|aligned_alloc)[[:space:]]*\(' "$work/code" |
    grep -v '^lib/base/env\.c:' >> "$work/found"
report "only lib/base/env.c takes memory"

# Those of the C library are calls, and of instructions that are slow beside ours on some processors: povtrace/math.h.
grep -E '(^|[^a-zA-Z0-9_.>])f(min|max)f?[[:space:]]*\(' "$work/code" >> "$work/found"
report "the lesser and the greater of two numbers are found without a call"

# The build of portable C, which `make bench-bits` holds the others against, has no vector code by hand.
grep -nE '#.*defined\(__x86_64__\)' $(sources lib plugins) | grep -vE 'POV_PORTABLE|_ONE_CLONE' >> "$work/found"
report "vector code is left out where POV_PORTABLE is defined"

grep -E '(^|[^a-zA-Z0-9_.>])(printf|puts|putchar|perror|exit|abort|_exit|fprintf)[[:space:]]*\(' "$work/code" \
    >> "$work/found"
report "the library and the plugins never print, exit or abort"

without_comments $(sources lib cli plugins tests) | grep -E '[^a-zA-Z0-9_](gets|tmpnam|mktemp)[[:space:]]*\(' \
    >> "$work/found"
report "no call that cannot be used safely"

sources lib plugins cli viewer tests | xargs grep -nP '\t|[ \t]+$' >> "$work/found"
report "no tab and no trailing blank"

# Worth a look, and no more: a reviewer may have been given the reason.
for file in $(sources lib plugins cli viewer tests); do
    lines=$(wc -l < "$file")
    [ "$lines" -le 600 ] || echo "note: $file has $lines lines"
done
sources lib plugins cli viewer tests | xargs awk '
    length($0) > 110 { n++; if (!(FILENAME in seen)) files++; seen[FILENAME] = 1 }
    END { if (n) print "note: " n " lines in " files " files are above 110 columns" }'

# ---- retired words ----

# Lines with a word of retired.txt where it may not stand; see there.
tree() {
    find lib plugins cli viewer tests docs README.md -type f ! -path 'docs/images/*' ! -path 'docs/notes/*' \
        ! -path 'tests/check/*' ! -path 'tests/golden/*' | LC_ALL=C sort
}
without_comments $(sources lib plugins cli viewer tests) | cut -d: -f1,3- > "$work/name"
grep -IH '' $(tree) > "$work/all"
grep -vE '^(#|$)' tests/check/retired.txt |
    while read -r kind word where but instead; do
        [ "$where" = - ] && where=.
        [ "$but" = - ] && but='^$'
        grep -iE "^[^:]*:(.*[^[:alpha:]])?($word)([^[:alpha:]]|\$)" "$work/$kind" | grep -E "$where" | grep -vE "$but" |
            while IFS= read -r line; do echo "say \"$instead\" for \"$word\": $line"; done
    done >> "$work/found"
report "no word of tests/check/retired.txt is used"

# ---- headers ----

for header in lib/include/povtrace/*.h; do
    name=povtrace/$(basename "$header")
    printf '#include <%s>\n#include <%s>\nint main(void) { return 0; }\n' "$name" "$name" > "$work/alone.c"
    cp "$work/alone.c" "$work/alone.cpp"
    $CC -std=c99 -Wall -Wextra -Wpedantic -Wshadow -Werror -Ilib/include -fsyntax-only "$work/alone.c" \
        >> "$work/found" 2>&1 || echo "$name does not compile alone as C99" >> "$work/found"
    $CXX -std=c++11 -Wall -Wextra -Wpedantic -Wshadow -Werror -Ilib/include -fsyntax-only "$work/alone.cpp" \
        >> "$work/found" 2>&1 || echo "$name does not compile alone as C++11" >> "$work/found"
done
report "every public header compiles alone, in C99 and in C++11"

# What a program reads, and what a primitive reads; the rest is arithmetic written out and the inner layout of the renderer.
lines=$(cd lib/include/povtrace && cat base.h math.h scene.h render.h trace.h image.h plot.h povtrace.h | wc -l)
[ "$lines" -lt 800 ] || echo "$lines lines for programs" > "$work/found"
lines=$(cd lib/include/povtrace && cat plugin.h shape.h | wc -l)
[ "$lines" -lt 350 ] || echo "$lines lines for primitives" >> "$work/found"
report "the headers for programs stay under 800 lines, those for primitives under 350"

# ---- what was built ----

# Variables that live where a program may write; constants with addresses in them are in .data.rel.ro.
changeable() {
    nm -A -f sysv "$@" 2>/dev/null | tr -d ' ' | awk -F'|' '
        $NF ~ /^(\.data|\.data\.rel|\.data\.rel\.local|\.bss|\.tbss|\.tdata|\*COM\*)$/ && $4 ~ /OBJECT|TLS/ { print $1 }'
}

library=$(ls "$BUILD"/lib/libpovtrace.so.*.*.* 2>/dev/null | head -n 1)
if [ -z "$library" ]; then
    echo "there is no library in $BUILD/lib" > "$work/found"
    report "the library was built"
else
    nm -D --defined-only "$library" | awk '$2 ~ /[A-Z]/ && $2 != "A" { sub(/@.*/, "", $3); print $3 }' |
        LC_ALL=C sort > "$work/exports"
    LC_ALL=C sort tests/api/exports.txt | diff - "$work/exports" > "$work/found" 2>&1
    report "the library exports what tests/api/exports.txt lists"

    ldd "$library" | awk '{ print $1 }' |
        grep -vE '^(linux-vdso\.so\.|linux-gate\.so\.|(/.*/)?ld-[a-z0-9-]*\.so|lib(c|m|dl|pthread)\.so)' > "$work/found"
    report "the library needs libc and libm only"

    changeable "$BUILD"/obj/lib/*/*.o > "$work/found"
    report "the library has no variable that can change"
fi

for plugin in "$BUILD"/lib/povtrace/*/*.so; do
    [ -e "$plugin" ] || { echo "there are no plugins in $BUILD/lib/povtrace" > "$work/found"; break; }
    nm -D --defined-only "$plugin" | awk '{ sub(/@.*/, "", $3); print $3 }' | grep -vx povtrace_plugin |
        sed "s|^|$plugin exports |" >> "$work/found"
    ldd "$plugin" | grep -q povtrace && echo "$plugin is linked against povtrace" >> "$work/found"
done
report "every plugin exports one symbol and needs nothing of povtrace"

for plugin in "$BUILD"/lib/povtrace/primitives/*.so; do
    source=plugins/primitives/$(basename "$plugin" .so).c
    [ -e "$source" ] || continue
    changeable "$BUILD/obj/${source%.c}.o" >> "$work/found"
done
report "no primitive has a variable that can change"

# ---- findings: each has a test ----

grep -v '^#' tests/findings.txt | while read -r finding file rest; do
    grep -qF -e "$rest" "$file" || echo "$finding: $file has no $rest"
done > "$work/found"
for finding in N1 N2 N3 N4 N5 N6 N7 $(seq -f 'F%g' 16) $(seq 30); do
    grep -q "^$finding " tests/findings.txt || echo "$finding has no test" >> "$work/found"
done
report "every finding of the reviews has a test"

# ---- mutations: what they change is there ----

if command -v python3 > "$work/python"; then
    python3 tests/mutate/mutate.py --places > "$work/found"
    report "the text of every mutation stands in one place"
fi

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
