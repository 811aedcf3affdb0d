#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Which options the scripts for clusters give to animate and which to encode, and that names reach them as they are:
# with GNU parallel itself, and other programs in the place of barycage-cli, which writes down what it is called with,
# and of Slurm, which runs each task at once and reads names of logs as Slurm does.
#   cluster_scripts_test.sh SCRIPTS
# shellcheck disable=SC1003,SC2016,SC2034,SC2317 # the fakes expand their variables themselves, and expect calls by name
set -uo pipefail
scripts=$(readlink -f -- "$1")
work=$(readlink -f -- "$(mktemp -d)")
trap 'rm -rf "$work"' EXIT
failures=0

fake() {
  cat >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}
mkdir "$work/bin" "$work/home" "$work/here"
fake barycage-cli <<'FAKE'
#!/bin/bash
# As a line in $LOG, and each argument with a zero behind it in a file of its own in $CALLS.
echo "$*" >>"$LOG"
printf '%s\0' "$@" >"$(mktemp "$CALLS/XXXXXX")"
if [[ " $* " == *" 999999/1000000 "* ]]; then exit "${REFUSES:-0}"; fi
if [[ " $* " == *" --dry-run "* ]]; then exit "${REFUSES_DRY:-0}"; fi
if [ "$1" = render ]; then : >"$3"; fi
FAKE
fake sbatch <<'FAKE'
#!/bin/bash
folder=$PWD log=slurm-%j.out array=
while [[ $1 == --* ]]; do
  case $1 in
  --chdir=*) folder=${1#*=} ;;
  --output=*) log=${1#*=} ;;
  --array=0-*) array=${1#*-*-*-} ;;
  --dependency=*) [ -z "${REFUSES_LAST:-}" ] || exit 1 ;;
  esac
  shift
done
task=$1
shift
# log_of TASK: in the whole path, a backslash is dropped, and then nothing is replaced.
log_of() {
  local rest=$log name=
  [[ $log == /* ]] || rest=$folder/$log
  if [[ $rest == *\\* ]]; then
    name=${rest//\\/}
  else
    while [ -n "$rest" ]; do
      if [[ $rest =~ ^%([0-9]*)([aAjJnNstu%]) ]]; then
        case ${BASH_REMATCH[2]} in
        %) name+=% ;;
        a) name+=$1 ;;
        A | j | J) name+=7 ;;
        N) name+=$HOSTNAME ;;
        u) name+=$USER ;;
        *) name+=0 ;;
        esac
        rest=${rest:${#BASH_REMATCH[0]}}
      else
        name+=${rest:0:1} rest=${rest:1}
      fi
    done
  fi
  log_path=$name
}
numbers=0
[ -z "$array" ] || numbers=$(seq 0 "$array")
cp -- "$task" "$LOG.task" || exit
for number in $numbers; do
  log_of "$number"
  (cd -- "$folder" && env ${array:+SLURM_ARRAY_TASK_ID=$number} SLURM_JOB_ID=7 bash "$LOG.task" "$@") >>"$log_path" 2>&1
done
echo '7;here'
FAKE
fake scancel <<'FAKE'
#!/bin/bash
echo "scancel $*" >>"$LOG"
FAKE
# Another machine: its login shell gets all words in one line.
fake ssh <<'FAKE'
#!/bin/bash
while [[ $1 == -* ]]; do shift; done
shift
[ "$1" != -- ] || shift
cd "$HOME" && exec sh -c "$*"
FAKE
echo "2/$work/bin/ssh far" >"$work/machines"
: >"$work/here/wind.ifs"

# calls SCRIPT ARGUMENT...: the log of what it called, its messages in $output and its exit status in $status.
calls() {
  : >"$work/log"
  rm -rf "$work/calls"
  mkdir "$work/calls"
  output=$(cd "${in:-$work/here}" && env -u BARYCAGE_CLI HOME="$work/home" SHELL=/bin/sh PATH="$work/bin:/usr/bin:/bin" \
    LOG="$work/log" CALLS="$work/calls" bash "$scripts/$1" "${@:2}" 2>&1)
  status=$?
}
drawing() { grep -E '^animate ' "$work/log" | grep -v 999999/1000000; }
encoding() { grep -E '^encode ' "$work/log" | grep -v -e --dry-run; }
expect() {
  if ! eval "$2"; then
    printf 'FAILED: %q: %s (status %s: %s)\n' "$1" "$2" "$status" "$output"
    cat "$work/log"
    failures=$((failures + 1))
  fi
}
# was_called ARGUMENT...: with exactly these.
was_called() {
  local call
  for call in "$work"/calls/*; do
    printf '%s\0' "$@" | cmp -s - "$call" && return
  done
  return 1
}
number_of_calls() { find "$work/calls" -type f | wc -l; }

for script in submit-animation.sh parallel-animation.sh; do
  for rate in '--fps 30' '--fps=30'; do
    # shellcheck disable=SC2086 # one argument or two
    calls $script wind.ifs 'high wind' wind.mp4 3 $rate --size 64x48 --frames 1-9
    expect "$script $rate" '[ $status -eq 0 ]'
    expect "$script $rate" '[ "$(drawing | grep -c -- "--size 64x48 --frames 1-9 -- ")" -eq 3 ]'
    expect "$script $rate" '! drawing | grep -q -- --fps'
    expect "$script $rate" 'encoding | grep -q -- "wind.mp4 --frames 1-9 $rate -- "'
  done
  calls $script wind.ifs wind wind.mp4 3
  expect "$script" 'encoding | grep -q -- "wind.mp4 --frames all -- "'
  calls $script wind.ifs wind 'frames/####.png' 3 --shutter 180
  expect "$script pictures" 'drawing | grep -q -- "frames/####.png .*--shutter 180 -- "'
  expect "$script pictures" '! encoding'
  # Said before anything is submitted or drawn.
  calls $script wind.ifs wind 'frames/####.png' 3 --fps 30
  expect "$script pictures with a rate" '[ $status -eq 2 ] && [[ $output == *"--fps applies only to videos"* ]]'
  expect "$script pictures with a rate" '[ ! -s "$work/log" ]'
  calls $script wind.ifs wind wind.mp4 3 --fps
  expect "$script without a rate" '[ $status -ne 0 ] && [[ $output == *"must follow --fps"* ]] && [ ! -s "$work/log" ]'
done

# refused SCRIPT SENTENCE ARGUMENT...: before anything is submitted.
refused() {
  calls "$1" "${@:3}"
  said=$2
  expect "$*" '[ $status -ne 0 ] && [[ $output == *"$said"* && $output != *Drawing* ]] && [ ! -s "$work/log" ]'
}
for script in submit-animation.sh parallel-animation.sh submit-picture.sh; do
  picture=o.png
  [ $script = submit-picture.sh ] || picture=o.##.png
  refused $script 'cannot be read' absent.ifs wind $picture 3
  refused $script 'TASKS must be a number' wind.ifs wind $picture 'a[$(touch canary)]'
  refused $script 'TASKS must be a number' wind.ifs wind $picture 0
  refused $script 'OUT must end in' wind.ifs wind $'o.mkv\n' 3
done
for script in submit-animation.sh parallel-animation.sh; do
  refused $script 'one group of #' wind.ifs wind '##/o.png' 3
  refused $script 'one group of #' wind.ifs wind '#.#.png' 3
  REFUSES=1 calls $script wind.ifs wind o.mkv 3
  expect "$script, what no task can draw" '[ $status -eq 1 ] && [ "$(number_of_calls)" -eq 1 ] && [[ $output != *Drawing* ]]'
  REFUSES_DRY=2 calls $script wind.ifs wind o.mkv 3 --fps 3O
  expect "$script, what cannot be made a video" \
    '[ $status -eq 2 ] && was_called encode -o "$work/here/o.mkv" --dry-run --frames all --fps 3O -- "$work/here/o.mkv.frames/######.png"'
  expect "$script, what cannot be made a video" '[ -z "$(drawing)$(encoding)" ] && [[ $output != *Drawing* ]]'
done
REFUSES_DRY=1 calls submit-picture.sh wind.ifs absent o.png 3 --points many
expect "a picture that no task can draw" '[ $status -eq 1 ] && [ "$(number_of_calls)" -eq 1 ] && [[ $output != *Drawing* ]]'
expect "a picture that no task can draw" 'was_called render -o "$work/here/o.png.parts/0.sum" --entry absent --part 0/3 \
  --dry-run --points many -- "$work/here/wind.ifs"'
for script in submit-animation.sh submit-picture.sh; do
  REFUSES_LAST=1 calls $script wind.ifs wind o.webp 3
  expect "$script, the last job refused" \
    '[ $status -ne 0 ] && grep -qx "scancel 7" "$work/log" && [[ $output != *Drawing* && $output == *cancelled* ]]'
done

# One of each kind, or all.
hostile=('{= system("touch canary") =}' '{}' '{#}' '{/}' '$(touch canary)' '`touch canary`' '"' "'" $'end\n' '%A %a %j'
  '%n' '#' '--' '*' '~' '{{Param.X}}' '\' $'\xff.')
if [ -n "${BARYCAGE_ALL:-}" ]; then
  hostile+=('{//}' '{.}' '{%}' '{1}' '{= $_=1 =}' $'a\nb' $'end\n\n' '%%' '%3' '##.##' '; touch canary;'
    '& touch canary &' '-o' '?[a]' 'two  words ' 'back\slash' '\\n' $'\u202e' '!!' '$HOME' $'\t' '+x' '(x)' '<x>' 'a,b')
fi
for name in "${hostile[@]}"; do
  path=${name//\/\///} # as the scripts resolve it
  in=$work/names/$path
  mkdir -p -- "$in"
  [[ $name != */* ]] || mkdir -p -- "$in/${path%/*}"
  : >"$in/$path"
  video=$in/$path.mkv frames=$in/$path.mkv.frames/######.png
  for machines in '' "--sshloginfile $work/machines"; do
    PARALLEL=$machines calls parallel-animation.sh "$name" "$name" "$name.mkv" 2 --palette "$name"
    for task in 0 1; do
      expect "parallel $machines $name" 'was_called animate -o "$frames" --entry "$name" --chunk $task/2 --threads 1 \
        --palette "$name" -- "$in/$path"'
    done
    expect "parallel $machines $name" 'was_called encode -o "$video" --frames all -- "$frames"'
    expect "parallel $machines $name" '[ $status -eq 0 ] && [ "$(number_of_calls)" -eq 5 ]'
  done
  calls submit-animation.sh "$name" "$name" "$name.mkv" 2 --palette "$name"
  for task in 0 1; do
    expect "Slurm $name" 'was_called animate -o "$frames" --entry "$name" --chunk $task/2 --threads 1 --palette "$name" \
      -- "$in/$path"'
    expect "Slurm $name" '[ -f "${frames%/*}/slurm-7-$task.log" ]'
  done
  expect "Slurm $name" 'was_called encode -o "$video" --frames all -- "$frames"'
  expect "Slurm $name" '[ $status -eq 0 ] && [ "$(number_of_calls)" -eq 5 ] && [[ $output == "Drawing: job 7, "* ]]'
  parts=$in/$path.png.parts
  calls submit-picture.sh "$name" "$name" "$name.png" 2 --palette "$name"
  for task in 0 1; do
    expect "picture $name" 'was_called render -o "$parts/$task.sum" --entry "$name" --part $task/2 --threads 1 \
      --palette "$name" -- "$in/$path"'
  done
  expect "picture $name" 'was_called merge -o "$in/$path.png" -- "$parts/0.sum" "$parts/1.sum"'
  expect "picture $name" '[ $status -eq 0 ] && [ "$(number_of_calls)" -eq 4 ]'
  # The scripts in such a folder themselves.
  cp "$scripts"/*.sh "$in"
  scripts=$in calls submit-animation.sh "$name" "$name" "$name.mkv" 2
  expect "scripts in $name" '[ $status -eq 0 ] && [ "$(number_of_calls)" -eq 5 ]'
done
expect "no name is run" '[ -z "$(find "$work" -name canary)" ]'
[ $failures -eq 0 ] && echo "passed"
exit $((failures > 0))
