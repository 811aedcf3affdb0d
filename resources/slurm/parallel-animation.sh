#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws an animation with GNU parallel, on this machine or on all of a list, and makes the video. The machines
# share the folder of the frames.
set -euo pipefail
if [ $# -lt 4 ]; then
  cat >&2 <<'TEXT'
Usage: parallel-animation.sh FILE ENTRY OUT TASKS [OPTION OF animate]...
For example: parallel-animation.sh wind.ifs wind wind.mp4 24 --size 1920x1080 --shutter 180
The frames are written to OUT.frames/######.png. The same command finishes work that was interrupted.
Options of parallel can be set in PARALLEL, such as PARALLEL='--sshloginfile machines --jobs 1'.
TEXT
  exit 2
fi
file=$(readlink -f -- "$1") entry=$2 output=$(realpath -m -- "$3") tasks=$4
shift 4
wanted=all # frames, which the options may choose
previous=
for option in "$@"; do
  [ "$previous" != --frames ] || wanted=$option
  [ "$option" = "${option#--frames=}" ] || wanted=${option#--frames=}
  previous=$option
done
frames=$output.frames
program=${BARYCAGE_CLI:-barycage-cli}
mkdir -p -- "$frames"
seq 0 $((tasks - 1)) | parallel --quote --retries 3 --joblog "$frames/jobs.log" \
  "$program" animate "$file" --entry "$entry" -o "$frames/######.png" --chunk "{}/$tasks" --threads 1 "$@"
"$program" encode "$frames/######.png" -o "$output" --frames "$wanted"
