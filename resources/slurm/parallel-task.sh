#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# One task of GNU parallel: its share of the frames of an animation.
#   parallel-task.sh TASK PROGRAM FILE ENTRY 'FRAMES/####.png' TASKS [OPTION]...
set -euo pipefail
task=$1 program=$2 file=$3 entry=$4 frames=$5 tasks=$6
shift 6
exec "${BARYCAGE_CLI:-$program}" animate -o "$frames" --entry "$entry" --chunk "$task/$tasks" --threads 1 "$@" -- "$file"
