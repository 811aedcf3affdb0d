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
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=resources/slurm/animation-options.sh
. "$here/animation-options.sh"
program=${BARYCAGE_CLI:-barycage-cli}
seq 0 $((tasks - 1)) | parallel --quote --retries 3 --joblog "$folder/jobs.log" \
  "$program" animate "$file" --entry "$entry" -o "$frames" --chunk "{}/$tasks" --threads 1 "${drawing[@]}"
[ "$frames" = "$output" ] || "$program" encode "$frames" -o "$output" --frames "$wanted" "${rate[@]}"
