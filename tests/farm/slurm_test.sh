#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# slurm_test.sh BARYCAGE_CLI SCRIPTS: starts a Slurm of its own on this machine, draws an animation with the job
# scripts in SCRIPTS, kills a node and a task midway, and compares every byte with what one process draws.
# shellcheck disable=SC1003,SC2016 # names of files that bash would expand elsewhere
set -euo pipefail
cli=$(readlink -f -- "$1") scripts=$(readlink -f -- "$2")
export BARYCAGE_CLI=$cli
folder=$(mktemp -d)
chmod 755 "$folder" # munged does not trust what others may write to
control=$((16000 + RANDOM % 8000 * 2)) node=$((control + 1))
me=$(id -un)
munge='' controller='' daemon=''

say() { printf '%s %s\n' "$(date +%T)" "$*"; }
fail() {
  say "FAILED: $*"
  tail -n 20 "$folder"/*.log "$folder"/drawn/wind.mkv.frames/*.log 2>/dev/null || true
  exit 1
}

stop() {
  local process
  for process in $(steps) $(programs) $daemon $controller $munge; do kill -9 "$process" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$folder"
}
trap stop EXIT
trap 'say "FAILED in line $LINENO"' ERR

# ours WORD: the processes of jobs of this Slurm, known by their environment, whose command line has the word.
ours() {
  local file
  for file in /proc/[0-9]*/environ; do
    grep -qz "^SLURM_CONF=$folder/slurm.conf$" "$file" 2>/dev/null || continue
    if tr '\0' ' ' <"${file%environ}cmdline" 2>/dev/null | grep -qE -- "$1"; then
      file=${file%/environ}
      echo "${file#/proc/}"
    fi
  done
}
programs() { ours "^$cli animate .*--chunk"; }
steps() { ours '^slurmstepd: |slurm_script'; }

# wait_for SECONDS COMMAND...: until it succeeds.
wait_for() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || fail "waited in vain for: $*"
    sleep 0.2
  done
}

configure() {
  mkdir -p "$folder"/{munge,state,spool,drawn}
  dd if=/dev/urandom of="$folder/munge/key" bs=1 count=1024 status=none
  chmod 700 "$folder/munge"
  chmod 600 "$folder/munge/key"
  cat >"$folder/slurm.conf" <<TEXT
ClusterName=test
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort=$control
SlurmdPort=$node
SlurmUser=$me
SlurmdUser=$me
AuthType=auth/munge
AuthInfo=socket=$folder/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmdTimeout=10
JobRequeue=1
SchedulerParameters=sched_interval=1,sched_min_interval=100000
NodeName=localhost NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=localhost Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
TEXT
  export SLURM_CONF=$folder/slurm.conf
}

start_node() {
  slurmd -D -N localhost -f "$folder/slurm.conf" >>"$folder/slurmd.log" 2>&1 &
  daemon=$!
}

start() {
  munged --foreground --force --key-file "$folder/munge/key" --socket "$folder/socket" --pid-file "$folder/munge/pid" \
    --log-file "$folder/munge/log" --seed-file "$folder/munge/seed" >"$folder/munged.log" 2>&1 &
  munge=$!
  wait_for 10 test -S "$folder/socket"
  slurmctld -D -f "$folder/slurm.conf" >"$folder/slurmctld.log" 2>&1 &
  controller=$!
  start_node
  wait_for 60 node_is_up
}

node_is_up() { sinfo --noheader --format=%t 2>/dev/null | grep -qE '^(idle|mix|alloc)$'; }
frames_there() { [ "$(find "$frames" -name '*.png' | wc -l)" -ge "$1" ]; }
running() { squeue --noheader --states=RUNNING --format=%i 2>/dev/null | grep -q .; }
queue_is_empty() { [ -z "$(squeue --noheader --format=%i 2>/dev/null || echo unknown)" ]; }

# One program that is drawing, killed as if memory had run out.
killed_one() {
  local victim
  victim=$(programs | sed -n 1p)
  [ -n "$victim" ] && kill -9 "$victim" 2>/dev/null && say "killed the program of a task (process $victim)"
}

# The node and all that runs on it, at once, as when the power fails; then it comes back.
kill_node() {
  local process
  wait_for 60 running
  kill -9 "$daemon"
  for process in $(steps) $(programs); do kill -9 "$process" 2>/dev/null || true; done
  wait "$daemon" 2>/dev/null || true
  say "killed the node"
  start_node
}

cat_animation() {
  cat <<'TEXT'
wind {
; barycage: animation 24 24/1 cycle
; barycage: motion sway
; barycage: strength 9
; barycage: pivot 0 0
; barycage: wave 1
; barycage: value 1 0 25
 -0.04 0 -0.23 -0.65 -0.08 0.26 .25
 0.61 0 0 0.31 0.07 3.5 .25
 0.65 0.29 -0.3 0.48 0.74 0.39 .25
 0.64 -0.3 0.16 0.56 -0.56 0.60 .25
}
TEXT
}

configure
start
cd "$folder/drawn"
frames=$folder/drawn/wind.mkv.frames
cat_animation >wind.ifs
options=(--size 320x240 --points 6e8 --shutter 90)
say "one process"
"$cli" animate wind.ifs --entry wind -o 'alone.######.png' "${options[@]}"
"$cli" encode 'alone.######.png' -o alone.mkv

say "24 frames in 6 tasks"
"$scripts/submit-animation.sh" wind.ifs wind wind.mkv 6 "${options[@]}"
wait_for 60 frames_there 3
wait_for 60 killed_one
wait_for 60 frames_there 7
kill_node
wait_for 300 queue_is_empty
[ -e wind.mkv ] || fail "there is no video"
[ "$(find "$frames" -name '*.png' | wc -l)" -eq 24 ] || fail "not 24 frames"
for number in $(seq 1 24); do
  name=$(printf '%06d.png' "$number")
  cmp "alone.$name" "$frames/$name" || fail "$name differs"
done
cmp alone.mkv wind.mkv || fail "the videos differ"
requeued=$(grep -oE '[Rr]equeu.*JobId=[0-9_]+|JobId=[0-9_]+.*[Rr]equeu' "$folder/slurmctld.log" | grep -oE 'JobId=[0-9_]+' | sort -u | wc -l)
[ "$requeued" -ge 2 ] || fail "only $requeued tasks were queued again"
say "the same bytes; $requeued tasks were queued again"

say "a picture in 4 parts"
"$scripts/submit-picture.sh" wind.ifs wind wind.png 4 --size 320x240 --points 1e8
wait_for 120 queue_is_empty
"$cli" render wind.ifs --entry wind --size 320x240 --points 1e8 -o alone.png
cmp alone.png wind.png || fail "the pictures differ"

say "what cannot be drawn is refused before anything is submitted"
# refused SCRIPT ARGUMENT...
refused() {
  local said
  if said=$("$scripts/$1" "${@:2}" 2>&1) || [[ $said == *Drawing* ]]; then fail "it was not refused: $* ($said)"; fi
  queue_is_empty || fail "it is in the queue: $*"
}
refused submit-picture.sh wind.ifs absent no.png 2
refused submit-picture.sh wind.ifs wind no.png 2 --points many
refused submit-picture.sh wind.ifs wind no.png 2 --size 60x40 --no-such-option
refused submit-animation.sh wind.ifs absent no.mkv 2
refused submit-animation.sh wind.ifs wind no.mkv 2 --fps 3O
refused submit-animation.sh wind.ifs wind no.mkv 2 --frames 9-8

small=(--size 32x24 --points 1e4)
for name in '%n # %A' $'two  words\n' '##.%%_%j\'; do
  say "names such as $(printf %q "$name")"
  mkdir "$folder/drawn/$name"
  cd "$folder/drawn/$name"
  entry='%n#$x\'
  E=$entry awk 'NR == 1 { print ENVIRON["E"] " {"; next } { print }' ../wind.ifs >"$name"
  "$scripts/submit-animation.sh" "./$name" "$entry" "./$name.mkv" 2 "${small[@]}"
  "$scripts/submit-picture.sh" "./$name" "$entry" "./$name.png" 2 "${small[@]}"
  wait_for 120 queue_is_empty
  "$cli" animate "./$name" --entry "$entry" -o alone.mkv "${small[@]}"
  "$cli" render "./$name" --entry "$entry" -o alone.png "${small[@]}"
  cmp alone.mkv "./$name.mkv" || fail "the videos differ"
  cmp alone.png "./$name.png" || fail "the pictures differ"
  cd "$folder/drawn"
done

if command -v parallel >/dev/null; then
  say "GNU parallel"
  "$scripts/parallel-animation.sh" wind.ifs wind parallel.mkv 6 --size 320x240 --points 1e6
  "$cli" animate wind.ifs --entry wind --size 320x240 --points 1e6 -o alone.mkv
  cmp alone.mkv parallel.mkv || fail "the videos differ"
fi
say "passed"
