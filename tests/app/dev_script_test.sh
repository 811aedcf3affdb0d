#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What ./dev installs, when it asks, what it hands on and what its checks look at: a copy of it runs in a folder of its
# own, with other programs in the place of those that it calls.
#   dev_script_test.sh [ROOT]   (the folder with the script to test)
# shellcheck disable=SC2016 # the fakes expand their variables themselves
set -uo pipefail
root=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# fake NAME: a program whose script is read from stdin. $LOG takes what is called.
fake() {
  printf '#!/bin/bash\n%s\n' "$(cat)" >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

# begin NAME: an empty project, no package installed, a user who is not root.
begin() {
  name=$1
  rm -rf "${work:?}"/*
  mkdir -p "$work"/{bin,installed,project/{.ci,build}}
  cp "$root/dev" "$work/project"
  cp "$root/.ci/run" "$work/project/.ci"
  : >"$work/log"
  local program
  for program in cmake ctest valgrind gcovr xvfb-run clang-format clang-tidy codespell shellcheck; do
    fake "$program" <<<'echo "${0##*/} $* corpus=${BARYCAGE_CORPUS:-}" >>"$LOG"'
  done
  # Joins the sources of a folder, as CMake does.
  fake cmake <<'PROGRAM'
echo "${0##*/} $* corpus=${BARYCAGE_CORPUS:-}" >>"$LOG"
[[ $* == *"-B build/tidy "* ]] || exit 0
joined=$PWD/build/tidy/Unity/model.cxx
mkdir -p "$(dirname "$joined")"
printf '#include "%s"\n' "$PWD"/model/*.cpp >"$joined"
printf '  "file": "%s",\n' "$joined" "$PWD/build/tidy/a_autogen/moc.cpp" >build/tidy/compile_commands.json
PROGRAM
  fake id <<<'echo "${USER_ID:-1000}"'
  fake dpkg-query <<<'[ -e "$INSTALLED/${!#}" ] && echo install ok installed'
  fake apt-get <<'PROGRAM'
echo "apt-get $* frontend=${DEBIAN_FRONTEND:-}" >>"$LOG"
for package in "$@"; do touch -- "$INSTALLED/$package"; done
PROGRAM
  # As sudo does it: with little of the environment.
  fake sudo <<<'echo "sudo $*" >>"$LOG"; exec env -i PATH="$PATH" LOG="$LOG" INSTALLED="$INSTALLED" "$@"'
  # As git would list them: all files, by name.
  fake git <<'PROGRAM'
end='\n'
patterns=()
for argument in "${@:2}"; do
  case "$argument" in -z) end='\0' ;; --) ;; *) patterns+=("$argument") ;; esac
done
find . -type f -printf '%P\n' | LC_ALL=C sort | while read -r file; do
  for pattern in "${patterns[@]}"; do
    # shellcheck disable=SC2053 # a pattern
    if [[ $file == $pattern ]]; then printf "%s$end" "$file"; break; fi
  done
done
PROGRAM
}

# dev ARGUMENT...: runs the copy; its output is in $output, its exit status in $status. `environment` is added.
environment=()
dev() { run_in_project ./dev "$@"; }
run_in_project() {
  output=$(cd "$work/project" && env -u CI -u DEBIAN_FRONTEND -u BARYCAGE_CORPUS PATH="$work/bin:/usr/bin:/bin" \
    LOG="$work/log" INSTALLED="$work/installed" "${environment[@]}" "$@" 2>&1)
  status=$?
}

# at_a_terminal KEYS COMMAND: the same with a terminal at which somebody types.
at_a_terminal() { run_in_project script --quiet --return --command "$2" /dev/null < <(printf '%b' "$1"); }

expect() { # WHAT COMMAND...
  if ! "${@:2}"; then
    printf 'FAIL: %s: %s (exit status %s)\n--- output\n%s\n--- called\n%s\n' \
      "$name" "$1" "$status" "$output" "$(cat "$work/log")" >&2
    failures=$((failures + 1))
  fi
}
ends_with() { [ "$status" -eq "$1" ]; }
says() { [[ $output == *"$1"* ]]; }
called() { grep -q -- "$1" "$work/log"; }
not() { ! "$@"; }

begin "nobody can be asked"
for environment in BARYCAGE_NOTHING= CI=true; do
  dev build </dev/null
  expect "fails" ends_with 1
  expect "installs nothing" not called apt-get
  expect "builds nothing" not called cmake
  expect "says how to install" says "sudo apt-get install --no-install-recommends g++ cmake"
done
environment=(USER_ID=0)
dev build </dev/null
expect "root installs nothing either" not called apt-get
expect "root needs no sudo" not says "sudo apt-get"
environment=()

begin "somebody is asked"
environment=(CI=true)
at_a_terminal 'n\n' "./dev build"
expect "asks" says "Install them now?"
expect "fails after no" ends_with 1
expect "installs nothing after no" not called apt-get
at_a_terminal '\x04' "./dev build"
expect "fails at the end of input" ends_with 1
expect "installs nothing at the end of input" not called apt-get
at_a_terminal 'y\n' "./dev build"
expect "goes on after yes" ends_with 0
expect "installs after yes" called "apt-get install"
environment=()

for arguments in "--yes build" "build --yes"; do
  begin "$arguments"
  # shellcheck disable=SC2086 # several arguments
  dev $arguments </dev/null
  expect "passes" ends_with 0
  expect "installs" called "^apt-get install .*cmake"
  expect "asks nothing" not says "Install them now?"
  expect "keeps debconf quiet under sudo" called "^apt-get install .* frontend=noninteractive"
  expect "keeps the option to itself" not called "cmake.* --yes"
  : >"$work/log"
  dev build </dev/null
  expect "needs no package twice" ends_with 0
  expect "installs no package twice" not called apt-get
done

begin "root says --yes"
environment=(USER_ID=0)
dev build --yes </dev/null
expect "keeps debconf quiet" called "^apt-get install .* frontend=noninteractive"
expect "needs no sudo" not called sudo
environment=()

begin "continuous integration"
run_in_project .ci/run </dev/null
expect "passes" ends_with 0
expect "installs" called "^apt-get install"
expect "tests" called "^ctest --preset release"
expect "hands no option of its own to ctest" not called "ctest.* --yes"

begin "corpus"
mkdir -p "$work/shared/corpus" "$work/elsewhere"
dev --yes test </dev/null
expect "is not looked for" called "^ctest .* corpus=$"
environment=("BARYCAGE_CORPUS=../elsewhere")
dev test -R some </dev/null
expect "is read where the variable says" called "^ctest .* -R some corpus=$work/elsewhere$"
environment=()

begin "clang-tidy"
mkdir -p "$work/project/model"
echo '// SPDX-License-Identifier: MIT, one' >"$work/project/model/one.cpp"
echo '// SPDX-License-Identifier: MIT, two' >"$work/project/model/two.cpp"
dev --yes check </dev/null
joined=$work/project/build/tidy/Unity/model.cxx
expect "take the sources joined" called "^clang-tidy .*$joined"
expect "leave out what is generated" not called "^clang-tidy .*_autogen"
expect "see the first source as its own text" grep -q "MIT, one" "$joined"
expect "see the last source as its own text" grep -q "MIT, two" "$joined"

begin "licence headers"
dev --yes check </dev/null
header='// SPDX-License-Identifier: MIT'
mkdir -p "$work/project/model"
for file in CMakeLists.txt README.md model/a.h model/a.cpp app/b.cpp; do
  mkdir -p "$(dirname "$work/project/$file")"
  echo "$header" >"$work/project/$file"
done
dev check </dev/null
expect "pass when all have one" ends_with 0
echo >"$work/project/model/a.cpp"
dev check </dev/null
expect "fail when one is missing" ends_with 1
expect "name the file" says "model/a.cpp: no licence header"
expect "name no other file" not says "model/a.h: no licence header"
# More than xargs hands to one program, in order: the last of them would get no file with a header.
mkdir "$work/project/tests"
long=$work/project/tests/$(printf '%0240d' 0)
for number in {1000..1599}; do : >"$long$number.h"; done
dev check </dev/null
expect "fail when many are missing" ends_with 1
expect "name the first" says "1000.h: no licence header"
expect "name the last" says "1599.h: no licence header"
rm "$long"*
for file in dev .ci/run CMakeLists.txt model/a.h model/a.cpp app/b.cpp; do
  sed -i '1,2s/SPDX/XDPS/' "$work/project/$file"
done
dev check </dev/null
expect "fail when all are missing" ends_with 1
for file in dev .ci/run model/a.h model/a.cpp app/b.cpp CMakeLists.txt; do
  expect "name $file" says "$file: no licence header"
done
fake git <<<'exit 128'
fake cmake <<<'mkdir -p build/tidy; : >build/tidy/compile_commands.json'
: >"$work/log"
dev check </dev/null
expect "fail when no file was looked at" ends_with 1
expect "leave no check without files" not called "^clang-\|^codespell"

begin "everything"
mkdir -p "$work/project/"{tests/{farm,python,web,portable},resources/portable,build/release}
fake farm <<<'echo "farm $*" >>"$LOG"'
mv "$work/bin/farm" "$work/project/tests/farm/slurm_test.sh"
fake web <<<'echo "web $*" >>"$LOG"'
mv "$work/bin/web" "$work/project/tests/web/run.sh"
fake python <<<'echo "python $*" >>"$LOG"'
mv "$work/bin/python" "$work/project/tests/python/run.sh"
fake barycage-cli <<<'echo barycage-cli 1.2.3'
mv "$work/bin/barycage-cli" "$work/project/build/release"
fake bundle.sh <<<'echo "bundle $*" >>"$LOG"'
fake pack.sh <<<'echo "pack $*" >>"$LOG"; mkdir -p "$3"; touch "$3/$2.AppImage"'
mv "$work/bin/"{bundle,pack}.sh "$work/project/resources/portable"
fake portable_test.sh <<<'echo "portable $*" >>"$LOG"'
mv "$work/bin/portable_test.sh" "$work/project/tests/portable"
for folder in ifs attractor document io; do
  mkdir -p "$work/project/build/release/tests/$folder"
  fake some_tests <<<'[ "$1" != --list ] || echo some_test'
  cp "$work/bin/some_tests" "$work/project/build/release/tests/$folder"
done
mkdir -p "$work/project/build/"{coverage,fuzz/tests/fuzz}
for program in fuzz_readers fuzz_guided; do
  fake "$program" <<<'[ "$1" != --list ] || echo flame; echo "${0##*/} $*" >>"$LOG"'
  mv "$work/bin/$program" "$work/project/build/fuzz/tests/fuzz"
done
dev --yes test --all </dev/null
expect "passes" ends_with 0
fake ctest <<<'echo "ctest $*" >>"$LOG"; [[ $* != *release* ]]'
fake valgrind <<<'exit 99'
: >"$work/log"
dev test --all </dev/null
expect "fails when parts do" ends_with 1
parts=("release FAILED" "accessibility passed" "exports FAILED" "farm passed" "web passed" "python passed" "asan passed" "tsan passed" "valgrind FAILED"
  "coverage passed" "monkey FAILED" "fuzz passed" "portable passed")
results=$(tr -s ' ' <<<"${output##*Results}")
for part in "${parts[@]}"; do
  expect "reports $part" grep -q "test $part" <<<"$results"
done
expect "opens pages" called "^web build/release/barycage-cli build/npm"
expect "tests the Python module" called "^python .*python3 build/python/package"
expect "packs one file" called "^pack build/portable barycage-1.2.3-linux-"
expect "runs that file" called "^portable dist/barycage-1.2.3-linux-"
expect "draws on a farm" called "^farm build/release/barycage-cli resources/slurm"
expect "looks at the window" called "^xvfb-run .*accessible_tree.py"
expect "fuzzes after failures" called "^fuzz_guided "
expect "takes no tests at all for an error" called "^ctest .*tsan .*--no-tests=error"

[ "$failures" -eq 0 ] || { echo "$failures failed" >&2; exit 1; }
