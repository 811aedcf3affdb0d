#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#SBATCH --job-name=barycage-animate
#SBATCH --requeue
#SBATCH --open-mode=append
# One task of an array: its share of the frames of an animation.
#   sbatch --array=0-5 animate.sh FILE ENTRY 'FRAMES/####.png' 6 [OPTION]...
# Frames that are complete are left as they are, so a task that was killed simply runs again: Slurm does that
# when a node fails, and this script when its program was killed.
set -euo pipefail
file=$1 entry=$2 frames=$3 tasks=$4
shift 4
program=${BARYCAGE_CLI:-barycage-cli}
status=0
"$program" animate -o "$frames" --entry "$entry" --chunk "$SLURM_ARRAY_TASK_ID/$tasks" \
  --threads "${SLURM_CPUS_PER_TASK:-1}" "$@" -- "$file" || status=$?
if ((status > 128 && ${SLURM_RESTART_COUNT:-0} < 3)); then
  scontrol requeue "$SLURM_JOB_ID"
fi
exit "$status"
