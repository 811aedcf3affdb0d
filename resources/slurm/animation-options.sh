#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What submit-animation.sh and parallel-animation.sh make of their arguments: FILE ENTRY OUT TASKS [OPTION]...
# shellcheck disable=SC2034,SC2154 # they use all of it, and names.sh sets some
take_file "$1"
entry=$2
take_output "$3"
take_tasks "$4"
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

# has_one_number NAME: one group of #.
has_one_number() {
  local LC_ALL=C
  [[ $1 =~ ^[^#]*#+[^#]*$ ]]
}
case $ending in
png)
  frames=$output
  [ ${#rate[@]} -eq 0 ] || refuse "--fps applies only to videos, and $(shown "$output") stands for pictures."
  has_one_number "${frames##*/}" ||
    refuse "The name of the pictures must have one group of #, which stands for the number of the frame, such as
NAME.####.png, and $(shown "${frames##*/}") has not."
  ;;
mp4 | webm | mkv | gif | webp | apng) frames=$output.frames/######.png ;;
*) refuse "OUT must end in .png, .mp4, .webm, .mkv, .gif, .webp or .apng, and $(shown "${output##*/}") does not." ;;
esac
folder=${frames%/*}/
mkdir -p -- "$folder"

# The reasons why no frame could be drawn, or no video be made, are known before any task begins. One share of a
# million has no frame.
program=${BARYCAGE_CLI:-barycage-cli}
if command -v "$program" >/dev/null; then
  "$program" animate -o "$frames" --entry "$entry" --chunk 999999/1000000 "${drawing[@]}" -- "$file"
  if [ "$frames" != "$output" ]; then
    "$program" encode -o "$output" --dry-run --frames "$wanted" "${rate[@]}" -- "$frames"
  fi
fi
