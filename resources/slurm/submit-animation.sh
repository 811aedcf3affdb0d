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
here=$(readlink -f -- "${BASH_SOURCE[0]}")
here=${here%/*}
# shellcheck source=resources/slurm/names.sh
. "$here/names.sh"
# shellcheck source=resources/slurm/animation-options.sh
. "$here/animation-options.sh"
array='' video='' # which submit sets
write_job "$frames.draw.sh" "$here/animate.sh" "$file" "$entry" "$frames" "$tasks" "${drawing[@]}"
write_job "$frames.encode.sh" "$here/encode.sh" "$frames" "$output" --frames "$wanted" "${rate[@]}"
submit array "$folder" "$frames.draw.sh" --output=slurm-%A-%a.log --array="0-$((tasks - 1))"
if [ "$frames" = "$output" ]; then
  echo "Drawing: job $array, $tasks tasks. See them with: squeue -j $array"
  exit
fi
submit_last video "$array" "$folder" "$frames.encode.sh" --output=slurm-%j.log
echo "Drawing: job $array, $tasks tasks. Video: job $video. See them with: squeue -j $array,$video"
