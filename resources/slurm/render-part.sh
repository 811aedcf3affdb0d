#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#SBATCH --job-name=barycage-render
#SBATCH --requeue
#SBATCH --open-mode=append
# One task of an array: one part of a picture.
#   sbatch --array=0-15 render-part.sh FILE ENTRY FOLDER 16 [OPTION]...
set -euo pipefail
file=$1 entry=$2 folder=$3 tasks=$4
shift 4
status=0
"${BARYCAGE_CLI:-barycage-cli}" render -o "$folder/$SLURM_ARRAY_TASK_ID.sum" --entry "$entry" --part "$SLURM_ARRAY_TASK_ID/$tasks" \
  --threads "${SLURM_CPUS_PER_TASK:-1}" "$@" -- "$file" || status=$?
if ((status > 128 && ${SLURM_RESTART_COUNT:-0} < 3)); then
  scontrol requeue "$SLURM_JOB_ID"
fi
exit "$status"
