#!/bin/sh
# A picture in parts by GNU parallel, on this machine, or on others that share its folders (PARALLEL_ARGUMENTS='-S host1,host2').
# Usage: parallel.sh SCENE WIDTH HEIGHT OUTPUT PARTS [povc's options]
set -eu
scene=$1 width=$2 height=$3 output=$4 parts=$5
shift 5

while :; do
    # shellcheck disable=SC2086
    seq "$parts" | parallel ${PARALLEL_ARGUMENTS:-} --will-cite --retries 3 --halt now,fail=1 \
        povc "$scene" "$width" "$height" "$output" -t 1 -q --part "{}/$parts" "$@"
    status=0
    povc --merge "$output" || status=$?
    # 4: the next samples depend on the whole picture, and the parts are to go on.
    [ "$status" -eq 4 ] || exit "$status"
done
