#!/bin/sh
# tests/run.sh with programs that print what tests print.
. "$(dirname "$0")/../support/cases.sh"

# program NAME: a script of that name, from standard input.
program() {
    mkdir -p "$(dirname "$1")"
    { echo '#!/bin/sh'; cat; } > "$1"
    chmod +x "$1"
}

# cmocka's output for two tests, of which one was skipped: the list of those comes by standard error.
one_skipped() {
    program "$1" <<'END'
echo '[==========] Running 2 test(s).'
echo '[ RUN      ] a_test_that_passes'
echo '[       OK ] a_test_that_passes'
echo '[ RUN      ] a_test_that_cannot_be_run'
echo 'there is no moon'
echo '[  SKIPPED ] a_test_that_cannot_be_run'
echo '[  PASSED  ] 1 test(s).' >&2
echo '[  SKIPPED ] 1 test(s), listed below:' >&2
echo '[  SKIPPED ] a_test_that_cannot_be_run' >&2
END
}

runner_prints_a_line_for_each_program_and_the_sums() {
    one_skipped tests/unit/test_one
    program tests/unit/script.sh <<'END'
echo '3 passed, 0 failed'
END
    program tests/unit/newer.sh <<'END'
echo '4 passed, 0 failed, 2 skipped'
END
    expect 0 "$root/tests/run.sh" tests/unit/test_one tests/unit/script.sh tests/unit/newer.sh
    grep -Eq '^unit/test_one +1 passed +0 failed +1 skipped .* ok$' out || fail "$(cat out)"
    grep -Eq '^unit/script.sh +3 passed +0 failed +0 skipped .* ok$' out || fail "$(cat out)"
    [ "$(tail -n 1 out)" = "8 passed, 0 failed, 3 skipped" ] || fail "$(cat out)"
}

runner_defect_4_says_why_tests_were_skipped() {
    one_skipped tests/unit/test_one
    program tests/unit/script.sh <<'END'
echo 'ok a_case # skipped: no display'
echo '1 passed, 0 failed, 1 skipped'
END
    expect 0 "$root/tests/run.sh" tests/unit/test_one tests/unit/script.sh
    says out "skipped: unit/test_one: a_test_that_cannot_be_run: there is no moon"
    says out "skipped: unit/script.sh: a_case: no display"
    [ "$(grep -c '^skipped: ' out)" -eq 2 ] || fail "$(cat out)"
}

runner_defect_4_takes_a_program_of_skipped_tests_for_no_failure() {
    program tests/unit/test_none <<'END'
echo '[ RUN      ] only'
echo '[  SKIPPED ] only'
echo '[  PASSED  ] 0 test(s).'
echo '[  SKIPPED ] 1 test(s), listed below:'
echo '[  SKIPPED ] only'
END
    expect 0 "$root/tests/run.sh" tests/unit/test_none
    says out "skipped: unit/test_none: only: no reason given"
    [ "$(tail -n 1 out)" = "0 passed, 0 failed, 1 skipped" ] || fail "$(cat out)"
}

runner_shows_what_failing_programs_print() {
    program tests/unit/test_bad <<'END'
echo 'expected 1, found 2'
echo '[  FAILED  ] 2 test(s), listed below:' >&2
exit 2
END
    program tests/unit/test_crash <<'END'
echo '[  PASSED  ] 5 test(s).'
kill -SEGV $$
END
    program tests/unit/test_empty <<'END'
exit 0
END
    one_skipped tests/unit/test_good
    expect 1 "$root/tests/run.sh" tests/unit/test_bad tests/unit/test_crash tests/unit/test_empty tests/unit/test_good
    says out "---- unit/test_bad: exit status 2"
    says out "expected 1, found 2"
    says out "---- unit/test_crash: exit status 139"
    says out "---- unit/test_empty: exit status 0"
    says_not out "a_test_that_passes"
    [ "$(tail -n 1 out)" = "6 passed, 4 failed, 1 skipped" ] || fail "$(cat out)"
}

runner_keeps_the_outputs_of_programs_apart() {
    for i in 1 2 3 4 5 6 7 8; do
        program "tests/unit/test_$i" <<'END'
for line in 1 2 3 4 5 6 7 8 9; do echo "$0 line $line"; sleep .01; done
echo '0 passed, 1 failed'
END
    done
    expect 1 "$root/tests/run.sh" -j 8 tests/unit/test_*
    for i in 1 2 3 4 5 6 7 8; do
        grep -A 9 "^---- unit/test_$i:" out | grep -c "test_$i line" | grep -qx 9 || fail "$(cat out)"
    done
    says out "0 passed, 8 failed, 0 skipped"
}

runner_names_the_copies_and_skips_those_for_other_processors() {
    one_skipped tests/unit/test_one
    one_skipped tests/x86-64-v9/unit/test_one
    expect 0 "$root/tests/run.sh" "$PWD/tests/unit/test_one" "$PWD/tests/x86-64-v9/unit/test_one"
    grep -Eq '^unit/test_one, baseline +1 passed' out || fail "$(cat out)"
    grep -Eq '^unit/test_one, x86-64-v9 +0 passed +0 failed +1 skipped' out || fail "$(cat out)"
    says out "skipped: unit/test_one: this processor is not an x86-64-v9"
}

run_cases_of "$0" runner
end_cases
