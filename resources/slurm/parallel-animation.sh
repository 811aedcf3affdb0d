#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws an animation with GNU parallel, on this machine or on all of a list, and makes the video. The machines
# share the folder of the frames.
set -euo pipefail
if [ $# -lt 4 ]; then
  cat >&2 <<'TEXT'
Usage: parallel-animation.sh FILE ENTRY OUT TASKS [OPTION OF animate]...
For example: parallel-animation.sh wind.ifs wind wind.mp4 24 --size 1920x1080 --shutter 180
The frames are written to OUT.frames/######.png; where OUT is itself NAME.####.png, to these files, and no
video is made. --fps is the rate of the video. The same command finishes work that was interrupted.
Options of parallel can be set in PARALLEL, such as PARALLEL='--sshloginfile machines --jobs 1'.
TEXT
  exit 2
fi
file=$(readlink -f -- "$1") entry=$2 output=$(realpath -m -- "$3") tasks=$4
shift 4
wanted=all # frames, which the options may choose
drawing=() # options of animate
rate=()    # that of encode: frames have none
while [ $# -gt 0 ]; do
  case $1 in
  --fps=*) rate=("$1") ;;
  --fps)
    rate=("$1" "${2:?A rate must follow --fps, such as 24.}")
    shift
    ;;
  --frames=*)
    wanted=${1#--frames=}
    drawing+=("$1")
    ;;
  --frames)
    wanted=${2:?Numbers must follow --frames, such as 1-240.}
    drawing+=("$1" "$2")
    shift
    ;;
  *) drawing+=("$1") ;;
  esac
  shift
done
case $output in
*.png) frames=$output ;;
*) frames=$output.frames/######.png ;;
esac
if [ "$frames" = "$output" ] && [ ${#rate[@]} -gt 0 ]; then
  echo "--fps applies only to videos, and '$output' stands for pictures." >&2
  exit 2
fi
folder=$(dirname -- "$frames")
program=${BARYCAGE_CLI:-barycage-cli}
mkdir -p -- "$folder"
seq 0 $((tasks - 1)) | parallel --quote --retries 3 --joblog "$folder/jobs.log" \
  "$program" animate "$file" --entry "$entry" -o "$frames" --chunk "{}/$tasks" --threads 1 "${drawing[@]}"
[ "$frames" = "$output" ] || "$program" encode "$frames" -o "$output" --frames "$wanted" "${rate[@]}"
