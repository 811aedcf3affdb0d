#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# How names reach the tasks as they are, whatever they consist of. Slurm and GNU parallel have templates of their own,
# such as %n and {= … =}. So they are not told names: a script beside the frames holds these, and is given the number
# of its task.
# shellcheck disable=SC2034,SC2154 # other scripts use what these functions set

# refuse SENTENCE: before anything is submitted or drawn.
refuse() {
  printf '%s\n' "$1" >&2
  exit 2
}

# shown NAME: in printable ASCII.
shown() {
  local LC_ALL=C
  printf %q "$1"
}

# path_into VARIABLE COMMAND...: the path that the command prints, with the line feeds at its end, which $() removes.
path_into() {
  local text
  text=$("${@:2}" && printf .) || return
  text=${text%.}
  printf -v "$1" %s "${text%$'\n'}"
}

# take_file FILE: sets `file` to its absolute path.
take_file() {
  path_into file readlink -f -- "$1" || file=''
  if [ ! -f "$file" ] || [ ! -r "$file" ]; then refuse "$(shown "$1") cannot be read."; fi
}

# take_output OUT: sets `output` to its absolute path, a symbolic link at its end not followed: whether it may be, the
# kernel decides. Sets `ending` to its suffix in lower case.
take_output() {
  local name=${1##*/} folder=./
  case $1 in */*) folder=${1%/*}/ ;; esac
  path_into folder realpath -m -- "$folder" || refuse "$(shown "$1") is not the name of a file."
  output=${folder%/}/$name
  [ ! -d "$output" ] || refuse "$(shown "$1") is a folder."
  ending=${output##*/}
  ending=${ending##*.}
  ending=${ending,,}
}

# take_tasks TASKS: sets `tasks`. Arithmetic would evaluate what is no number, with the commands in it.
take_tasks() {
  local LC_ALL=C
  [[ $1 =~ ^[1-9][0-9]{0,5}$ ]] || refuse "TASKS must be a number from 1 to 999999, and $(shown "$1") is none."
  tasks=$1
}

# is_template FOLDER: Slurm replaces % and \ in the whole path of a log, those of its folder too.
is_template() {
  [[ $1 == *[%\\]* ]]
}

start='' # what tasks begin with

# write_task TASK SCRIPT [ARGUMENT]...: the script TASK, which does in this folder what SCRIPT does with the arguments
# of TASK and these. It is ASCII, and read in the same way in every locale.
write_task() {
  local LC_ALL=C task=$1 script=$2
  shift 2
  {
    sed '/^[^#]/,$d' "$script" &&
      printf '[ ! -d %q ] || cd %q\n' "$PWD" "$PWD" &&
      printf %s "$start" &&
      printf 'set -- "$@"' && printf ' %q' "$@" && printf '\n' &&
      sed -n '/^[^#]/,$p' "$script"
  } >"$task.$$" && mv -fT -- "$task.$$" "$task"
}

# write_job TASK SCRIPT [ARGUMENT]...: write_task for Slurm. Where the path of a log would be a template, the job writes
# its log itself, without what Slurm has to say.
write_job() {
  local LC_ALL=C start=''
  # shellcheck disable=SC2016 # the bash of the task expands it
  ! is_template "${1%/*}" || printf -v start 'exec >>%q"%s" 2>&1\n' "${1%/*}/" \
    'slurm-${SLURM_ARRAY_JOB_ID:-$SLURM_JOB_ID}${SLURM_ARRAY_TASK_ID:+-$SLURM_ARRAY_TASK_ID}.log'
  write_task "$@"
}

# submit VARIABLE FOLDER TASK OPTION...: VARIABLE becomes the number of the job, which write_job has written.
submit() {
  local number log=()
  ! is_template "$2" || log=(--output=/dev/null)
  number=$(sbatch --parsable --chdir="$2" "${@:4}" "${log[@]}" "$3") || return
  number=${number%%;*} # without the name of the cluster
  case $number in
  '' | *[!0123456789]*)
    echo "sbatch gave no number of a job." >&2
    return 1
    ;;
  esac
  printf -v "$1" %s "$number"
}

# submit_last VARIABLE ARRAY FOLDER TASK OPTION...: what comes after the tasks of the array, which would be in vain
# without it.
submit_last() {
  submit "$1" "${@:3}" --dependency="afterok:$2" --kill-on-invalid-dep=yes && return
  scancel "$2"
  echo "The last job was not accepted, so the tasks before it, job $2, were cancelled." >&2
  exit 1
}
