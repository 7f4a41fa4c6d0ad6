#!/bin/sh
# Run test programs side by side, a job for each core: run.sh [-j JOBS] PROGRAM...
#
# A program prints cmocka's summary, or a line "N passed, N failed" or "N passed, N failed, N skipped"; its scripts print
# "ok NAME # skipped: WHY" for a case that they skip. A program below a folder x86-64-vN is built for such processors and
# is skipped on others.
#
# Prints a line for each program when it ends; then the output of those that failed, what was skipped and why, the sums.

# The name of a program, with the copy of the library that it tests where there are several.
name_of() {
    name=${1##*/tests/}
    name=${name#tests/}
    case $name in
    x86-64-v[0-9]/*) echo "${name#*/}, ${name%%/*}" ;;
    *) case " $programs " in *"/tests/x86-64-v"[0-9]"/$name "*) echo "$name, baseline" ;; *) echo "$name" ;; esac ;;
    esac
}

# The C library's loader knows which x86-64-vN this processor is.
can_run() {
    for loader in /lib64/ld-linux-x86-64.so.2 /lib/ld-linux-x86-64.so.2; do
        [ -x "$loader" ] && "$loader" --help 2>/dev/null | grep -q "^ *$1 (supported" && return 0
    done
    return 1
}

# count NAME STATUS OUTPUT ERRORS: prints a line "passed failed skipped", then one for each skipped test.
count() {
    awk -v name="$1" -v status="$2" '
        function skip(test, why) {
            sub(/ +$/, "", why)
            reasons = reasons "skipped: " name ": " test ": " (why == "" ? "no reason given" : why) "\n"
        }
        # A program may hold several groups of cmocka; each prints its own summary.
        /^\[  PASSED  \] [0-9]+ test/ { passed += $4; next }
        /^\[  FAILED  \] [0-9]+ test/ { failed += $4; next }
        /^\[  SKIPPED \] [0-9]+ test/ { skipped += $4; next }
        # What a test prints before it skips is its reason.
        /^\[ RUN      \] / { test = substr($0, 14); said = ""; next }
        /\[  SKIPPED \] / && test != "" {
            skip(test, said substr($0, 1, index($0, "[  SKIPPED ]") - 1)); test = ""; next
        }
        /^ok .* # skipped: / { at = index($0, " # skipped: "); skip(substr($0, 4, at - 4), substr($0, at + 12)) }
        /^[0-9]+ passed, [0-9]+ failed/ { passed += $1; failed += $3; skipped += $5 }
        /^\[ / { test = "" }
        test != "" { said = said $0 " " }
        END {
            # A program that ends badly, or that ran nothing, has failed even where it counted no failure.
            if (failed == 0 && (status != 0 || passed + skipped == 0))
                failed = 1
            printf "%d %d %d\n%s", passed, failed, skipped, reasons
        }' "$3" "$4"
}

# Run one program; what is to be said at the end goes to files beside the line.
run_one() {
    name=$(name_of "$1")
    files=$work/$(echo "$name" | tr '/ ' '__')
    copy=${1##*/tests/}
    copy=${copy%%/*}
    start=$(date +%s)
    case $copy in
    x86-64-v[0-9]) can_run "$copy" || { echo 0 0 1; echo "skipped: $name: this processor is not an $copy"; } > "$files.count" ;;
    esac
    if [ ! -s "$files.count" ]; then
        timeout 900 "$1" > "$files.out" 2> "$files.err"
        status=$?
        count "$name" "$status" "$files.out" "$files.err" > "$files.count"
    fi
    read -r p f s < "$files.count"
    verdict=ok
    [ "$f" -eq 0 ] || verdict=FAILED
    if [ "$f" -gt 0 ]; then
        { echo "---- $name: exit status $status"; cat "$files.out" "$files.err"; } > "$files.failed"
    fi
    printf '%-44s %5d passed %4d failed %4d skipped %4ds  %s\n' "$name" "$p" "$f" "$s" $(($(date +%s) - start)) "$verdict"
}

if [ "$1" = --one ]; then
    work=$2 programs=$3
    run_one "$4"
    exit 0
fi

jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
[ "$1" = -j ] && jobs=$2 && shift 2
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
printf '%s\n' "$@" | xargs -P "$jobs" -I '{}' "$0" --one "$work" "$*" '{}'
cat "$work"/*.failed 2>/dev/null
# The copies skip for the same reasons.
cat "$work"/*.count | sed -n 's/^\(skipped: [^:,]*\)[^:]*/\1/p' | awk '!n[$0]++ { line[++lines] = $0 }
    END { for (i = 1; i <= lines; i++) print line[i] (n[line[i]] > 1 ? ", " n[line[i]] " times" : "") }'
cat "$work"/*.count | awk '/^[0-9]/ { p += $1; f += $2; s += $3; n++ }
    END { printf "%d passed, %d failed, %d skipped\n", p, f, s; exit f > 0 || n != '$#' }'
