# cases.sh - a small runner for tests in POSIX shell, to be sourced.
#
# A case is a function whose name is a sentence. `run_case NAME` runs it under `set -e` in an empty folder of its own and
# prints "ok NAME", or "not ok NAME" and what it said. A case that cannot be run here calls `skip WHY`. `end_cases`
# prints "N passed, N failed, N skipped" and fails if any failed.

root=$(cd "$(dirname "$0")/../.." && pwd)
BUILD_DIR=${BUILD_DIR:-$root/build}
CC=${CC:-cc}
CXX=${CXX:-c++}
PYTHON=${PYTHON:-python3}
povc=$BUILD_DIR/bin/povc
LC_ALL=C
export LC_ALL
unset NO_COLOR POVTRACE_PLUGIN_PATH

cases_folder=$(mktemp -d "${TMPDIR:-/tmp}/povtrace-cases.XXXXXX") || exit 1
trap 'rm -rf "$cases_folder"' EXIT
trap 'exit 1' HUP INT TERM
passed=0 failed=0 skipped=0

skip() {
    echo "$*" > "$cases_folder/skipped"
    exit 0
}

run_case() {
    mkdir "$cases_folder/$1"
    rm -f "$cases_folder/skipped"
    # Not as a condition: that would switch `set -e` off within.
    (
        set -e
        cd "$cases_folder/$1"
        "$1"
    ) > "$cases_folder/log" 2>&1
    status=$?
    if [ "$status" -ne 0 ]; then
        failed=$((failed + 1))
        echo "not ok $1"
        sed 's/^/    /' "$cases_folder/log" | head -n 40
    elif [ -e "$cases_folder/skipped" ]; then
        skipped=$((skipped + 1))
        echo "ok $1 # skipped: $(cat "$cases_folder/skipped")"
    else
        passed=$((passed + 1))
        echo "ok $1"
    fi
    rm -rf "${cases_folder:?}/$1"
}

# Every function of the file whose name begins with the word.
run_cases_of() {
    for name in $(sed -n "s/^\\($2_[a-z0-9_]*\\)() {\$/\\1/p" "$1"); do
        run_case "$name"
    done
}

end_cases() {
    echo "$passed passed, $failed failed, $skipped skipped"
    [ "$failed" -eq 0 ]
}

# ---- for cases ----

fail() {
    echo "$*"
    exit 1
}

# expect STATUS COMMAND...: its output goes to the files out and err.
expect() {
    expected=$1
    shift
    actual=0
    "$@" > out 2> err || actual=$?
    if [ "$actual" -ne "$expected" ]; then
        echo "exit status $actual instead of $expected: $*"
        head -n 20 err
        exit 1
    fi
}

# says FILE TEXT: the text stands in the file, letter for letter.
says() {
    grep -qF -- "$2" "$1" || fail "$1 does not say \"$2\" but: $(head -n 20 "$1")"
}

says_not() {
    if grep -qF -- "$2" "$1"; then
        fail "$1 says \"$2\""
    fi
}

same() {
    cmp "$1" "$2" || fail "$1 and $2 differ"
}
