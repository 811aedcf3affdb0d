#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Submits one picture to Slurm: an array of tasks that draw its parts, and a job that puts them together.
set -euo pipefail
if [ $# -lt 4 ]; then
  cat >&2 <<'TEXT'
Usage: submit-picture.sh FILE ENTRY OUT.png TASKS [OPTION OF render]...
For example: submit-picture.sh paper.ifs maple maple.png 16 --size 8000x6000 --points 1e13
The parts are written to OUT.png.parts, which may be removed afterwards, or kept to add points to the picture.
Options of sbatch can be set in its variables, such as SBATCH_PARTITION and SBATCH_TIMELIMIT.
TEXT
  exit 2
fi
here=$(readlink -f -- "${BASH_SOURCE[0]}")
here=${here%/*}
# shellcheck source=resources/slurm/names.sh
. "$here/names.sh"
take_file "$1"
entry=$2
take_output "$3"
take_tasks "$4"
shift 4
case $ending in
png | jpg | jpeg | webp | tif | tiff | exr | sum) ;;
*) refuse "OUT must end in .png, .jpg, .webp, .tiff, .exr or .sum, and $(shown "${output##*/}") does not." ;;
esac
parts=$output.parts
mkdir -p -- "$parts"
# The reason why no part could be drawn is known before any task begins.
program=${BARYCAGE_CLI:-barycage-cli}
if command -v "$program" >/dev/null; then
  "$program" render -o "$parts/0.sum" --entry "$entry" --part "0/$tasks" --dry-run "$@" -- "$file"
fi
array='' merge='' # which submit sets
write_job "$parts/render.sh" "$here/render-part.sh" "$file" "$entry" "$parts" "$tasks" "$@"
write_job "$parts/merge.sh" "$here/merge.sh" "$parts" "$output"
submit array "$parts" "$parts/render.sh" --output=slurm-%A-%a.log --array="0-$((tasks - 1))"
submit_last merge "$array" "$parts" "$parts/merge.sh" --output=slurm-%j.log
echo "Drawing: job $array, $tasks tasks. Picture: job $merge. See them with: squeue -j $array,$merge"
