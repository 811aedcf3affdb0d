#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#SBATCH --job-name=barycage-encode
#SBATCH --requeue
#SBATCH --open-mode=append
# Makes a video from the frames, once all of them are there.
#   sbatch --dependency=afterok:JOB encode.sh 'FRAMES/####.png' OUT.mp4 [OPTION]...
set -euo pipefail
frames=$1 output=$2
shift 2
exec "${BARYCAGE_CLI:-barycage-cli}" encode -o "$output" "$@" -- "$frames"
