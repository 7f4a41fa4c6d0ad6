#!/bin/sh
# One task of the array that slurm.sh submits.
scene=$1 width=$2 height=$3 output=$4 parts=$5
shift 5
exec povc "$scene" "$width" "$height" "$output" -t "${SLURM_CPUS_PER_TASK:-1}" -q --part "$SLURM_ARRAY_TASK_ID/$parts" "$@"
