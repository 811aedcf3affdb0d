#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Which options the scripts for clusters give to animate and which to encode: with other programs in the place of
# barycage-cli, sbatch and parallel, which write down what they are called with.
#   cluster_scripts_test.sh SCRIPTS
# shellcheck disable=SC2016,SC2317 # the fakes expand their variables themselves, and expect calls by name
set -uo pipefail
scripts=$(readlink -f -- "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

fake() {
  printf '#!/bin/bash\n%s\n' "$2" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}
mkdir "$work/bin"
fake sbatch 'echo "$*" >>"$LOG"; echo 7'
fake barycage-cli 'echo "$*" >>"$LOG"'
fake parallel 'cat >/dev/null; while [ "$1" != barycage-cli ]; do shift; done; "$@"'

# calls SCRIPT ARGUMENT...: the log of what it called, its messages in $output and its exit status in $status.
calls() {
  : >"$work/log"
  output=$(cd "$work" && env -u BARYCAGE_CLI PATH="$work/bin:/usr/bin:/bin" LOG="$work/log" "$scripts/$1" "${@:2}" 2>&1)
  status=$?
}
drawing() { grep -E 'animate(\.sh)? ' "$work/log"; }
encoding() { grep -E 'encode(\.sh)? ' "$work/log"; }
expect() {
  if ! eval "$2"; then
    echo "FAILED: $1: $2 (status $status: $output)"
    cat "$work/log"
    failures=$((failures + 1))
  fi
}

for script in submit-animation.sh parallel-animation.sh; do
  for rate in '--fps 30' '--fps=30'; do
    # shellcheck disable=SC2086 # one argument or two
    calls $script wind.ifs 'high wind' wind.mp4 3 $rate --size 64x48 --frames 1-9
    expect "$script $rate" '[ $status -eq 0 ]'
    expect "$script $rate" 'drawing | grep -q -- "--size 64x48 --frames 1-9$"'
    expect "$script $rate" '! drawing | grep -q -- --fps'
    expect "$script $rate" 'encoding | grep -q -- "wind.mp4 --frames 1-9 $rate$"'
  done
  calls $script wind.ifs wind wind.mp4 3
  expect "$script" 'encoding | grep -q -- "wind.mp4 --frames all$"'
  calls $script wind.ifs wind 'frames/####.png' 3 --shutter 180
  expect "$script pictures" 'drawing | grep -q -- "frames/####.png .*--shutter 180$\|frames/####.png 3 --shutter 180$"'
  expect "$script pictures" '! encoding'
  # Said before anything is submitted or drawn.
  calls $script wind.ifs wind 'frames/####.png' 3 --fps 30
  expect "$script pictures with a rate" '[ $status -eq 2 ] && [[ $output == *"--fps applies only to videos"* ]]'
  expect "$script pictures with a rate" '[ ! -s "$work/log" ]'
  calls $script wind.ifs wind wind.mp4 3 --fps
  expect "$script without a rate" '[ $status -ne 0 ] && [[ $output == *"must follow --fps"* ]] && [ ! -s "$work/log" ]'
done
[ $failures -eq 0 ] && echo "passed"
exit $((failures > 0))
