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
here=$(readlink -f -- "${BASH_SOURCE[0]}")
here=${here%/*}
# shellcheck source=resources/slurm/names.sh
. "$here/names.sh"
# shellcheck source=resources/slurm/animation-options.sh
. "$here/animation-options.sh"
task=$frames.draw.sh
write_task "$task" "$here/parallel-task.sh" "$program" "$file" "$entry" "$frames" "$tasks" "${drawing[@]}"
# The path of the script is a name as well: each of its bytes becomes \0 and three digits, which mean nothing to GNU
# parallel, nor to the shells on the way.
path=$(printf %s "$task" | od -An -v -t o1 | tr -d '\n')
# shellcheck disable=SC2016 # the bash of the task expands it
run='exec bash "$(printf %b "'${path// /\\0}'")" "$0"'
seq 0 $((tasks - 1)) | parallel --retries 3 --joblog "${folder}jobs.log" "bash -c '$run' {}"
[ "$frames" = "$output" ] || "$program" encode -o "$output" --frames "$wanted" "${rate[@]}" -- "$frames"
