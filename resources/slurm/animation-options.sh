#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What submit-animation.sh and parallel-animation.sh make of their arguments: FILE ENTRY OUT TASKS [OPTION]...
# shellcheck disable=SC2034 # they use all of it
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
mkdir -p -- "$folder"
