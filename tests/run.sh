#!/bin/sh
# Run test programs one after the other: run.sh PROGRAM... Each prints either cmocka's summary or a line
# "N passed, N failed". The output of a program is shown only when something in it failed. Ends with the sums.
passed=0 failed=0
log=$(mktemp) || exit 1
trap 'rm -f "$log"' EXIT
for program in "$@"; do
    start=$(date +%s)
    timeout 900 "$program" >"$log" 2>&1
    status=$?
    # A program may hold several groups; each prints its own summary.
    p=$(sed -n 's/^\[  PASSED  \] \([0-9]*\) test.*/\1/p; s/^\([0-9]*\) passed, [0-9]* failed.*/\1/p' "$log" | awk '{n += $1} END {print n + 0}')
    f=$(sed -n 's/^\[  FAILED  \] \([0-9]*\) test.*/\1/p; s/^[0-9]* passed, \([0-9]*\) failed.*/\1/p' "$log" | awk '{n += $1} END {print n + 0}')
    # A program that ends badly, or that ran nothing, has failed even where it counted no failure.
    if [ "$f" -eq 0 ] && { [ "$status" -ne 0 ] || [ "$p" -eq 0 ]; }; then
        f=1
    fi
    passed=$((passed + p)) failed=$((failed + f))
    verdict=ok
    [ "$f" -gt 0 ] && verdict=FAILED
    printf '%-44s %5d passed %4d failed %4ds  %s\n' "$(echo "$program" | sed 's|.*/tests/||')" "$p" "$f" $(($(date +%s) - start)) "$verdict"
    [ "$f" -gt 0 ] && { echo "exit status $status"; cat "$log"; }
done
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
