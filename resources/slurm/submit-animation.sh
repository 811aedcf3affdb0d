#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Submits an animation to Slurm: an array of tasks that draw the frames, and a job that makes the video.
set -euo pipefail
if [ $# -lt 4 ]; then
  cat >&2 <<'TEXT'
Usage: submit-animation.sh FILE ENTRY OUT TASKS [OPTION OF animate]...
For example: submit-animation.sh wind.ifs wind wind.mp4 24 --size 1920x1080 --points 1e9 --shutter 180
The frames are written to OUT.frames/######.png; where OUT is itself NAME.####.png, to these files, and no
video is made. --fps is the rate of the video. The same command finishes work that was interrupted.
Options of sbatch can be set in its variables, such as SBATCH_PARTITION and SBATCH_TIMELIMIT.
TEXT
  exit 2
fi
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=resources/slurm/animation-options.sh
. "$here/animation-options.sh"
array=$(sbatch --parsable --output="$folder/slurm-%A-%a.log" --array="0-$((tasks - 1))" \
  "$here/animate.sh" "$file" "$entry" "$frames" "$tasks" "${drawing[@]}")
array=${array%%;*} # without the name of the cluster
if [ "$frames" = "$output" ]; then
  echo "Drawing: job $array, $tasks tasks. See them with: squeue -j $array"
  exit
fi
video=$(sbatch --parsable --output="$folder/slurm-%j.log" --dependency="afterok:$array" --kill-on-invalid-dep=yes \
  "$here/encode.sh" "$frames" "$output" --frames "$wanted" "${rate[@]}")
echo "Drawing: job $array, $tasks tasks. Video: job ${video%%;*}. See them with: squeue -j $array,${video%%;*}"
