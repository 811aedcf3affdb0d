#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Submits an animation to Slurm: an array of tasks that draw the frames, and a job that makes the video.
set -euo pipefail
if [ $# -lt 4 ]; then
  cat >&2 <<'TEXT'
Usage: submit-animation.sh FILE ENTRY OUT TASKS [OPTION OF animate]...
For example: submit-animation.sh wind.ifs wind wind.mp4 24 --size 1920x1080 --points 1e9 --shutter 180
The frames are written to OUT.frames/######.png. The same command finishes work that was interrupted.
Options of sbatch can be set in its variables, such as SBATCH_PARTITION and SBATCH_TIMELIMIT.
TEXT
  exit 2
fi
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
file=$(readlink -f -- "$1") entry=$2 output=$(realpath -m -- "$3") tasks=$4
shift 4
frames=$output.frames
mkdir -p -- "$frames"
log=(--output="$frames/slurm-%A-%a.log")
array=$(sbatch --parsable "${log[@]}" --array="0-$((tasks - 1))" \
  "$here/animate.sh" "$file" "$entry" "$frames/######.png" "$tasks" "$@")
array=${array%%;*} # without the name of the cluster
video=$(sbatch --parsable --output="$frames/slurm-%j.log" --dependency="afterok:$array" \
  "$here/encode.sh" "$frames/######.png" "$output")
echo "Drawing: job $array, $tasks tasks. Video: job ${video%%;*}. See them with: squeue -j $array,${video%%;*}"
