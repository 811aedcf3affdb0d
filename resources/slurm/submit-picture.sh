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
here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
file=$(readlink -f -- "$1") entry=$2 output=$(realpath -m -- "$3") tasks=$4
shift 4
parts=$output.parts
mkdir -p -- "$parts"
array=$(sbatch --parsable --output="$parts/slurm-%A-%a.log" --array="0-$((tasks - 1))" \
  "$here/render-part.sh" "$file" "$entry" "$parts" "$tasks" "$@")
array=${array%%;*} # without the name of the cluster
merge=$(sbatch --parsable --output="$parts/slurm-%j.log" --dependency="afterok:$array" --kill-on-invalid-dep=yes \
  "$here/merge.sh" "$parts" "$output")
echo "Drawing: job $array, $tasks tasks. Picture: job ${merge%%;*}. See them with: squeue -j $array,${merge%%;*}"
