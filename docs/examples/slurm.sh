#!/bin/sh
# A picture in parts by a job array of Slurm; the nodes share this folder. It waits for the picture: nohup, tmux or another
# job keep it running. What a node that fails had begun, Slurm runs again elsewhere.
# Usage: slurm.sh SCENE WIDTH HEIGHT OUTPUT PARTS [povc's options]     (SBATCH_ARGUMENTS='--partition=... --time=...')
set -eu
scene=$1 width=$2 height=$3 output=$4 parts=$5
shift 5

while :; do
    # shellcheck disable=SC2086
    sbatch --quiet --wait --array="1-$parts" --requeue --cpus-per-task=1 --output=/dev/null ${SBATCH_ARGUMENTS:-} \
        "$(dirname "$0")/slurm_part.sh" "$scene" "$width" "$height" "$output" "$parts" "$@" || true
    status=0
    povc --merge "$output" || status=$?
    # 4: the next samples depend on the whole picture, and the parts are to go on.
    [ "$status" -eq 4 ] || exit "$status"
done
