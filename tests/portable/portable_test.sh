#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# portable_test.sh FILE.AppImage: whether Barycage in one file runs in bare systems, which have nothing but glibc and
# libstdc++: pictures are those of build/release, the window starts, and a drag in it moves the fractal.
# shellcheck disable=SC2317 # check() calls the functions
set -euo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.."
file=$(realpath --relative-to=. "$1")
work=build/portable-test
rm -rf "$work"
mkdir -p "$work/Ordner mit Ümläuten"
cp "$file" "$work/Ordner mit Ümläuten/Bary cage.AppImage"
failed=0

check() { # check WHAT COMMAND...
  if "${@:2}"; then printf 'passed  %s\n' "$1"; else printf 'FAILED  %s\n' "$1"; failed=1; fi
}
in_suite() { resources/toolchain/debian.sh "$1" libstdc++6 -- "${@:2}"; }

picture=(render ifs_library/paper.ifs --entry maple --size 300x200 --to png -o)
build/release/barycage-cli "${picture[@]}" "$work/expected.png"
same_picture() { # same_picture SUITE COMMAND...
  rm -f "$work/found.png"
  in_suite "$1" "${@:2}" "${picture[@]}" "$work/found.png" && cmp "$work/expected.png" "$work/found.png"
}

says_what_is_missing() {
  local said
  ! said=$(in_suite bullseye "$file" --appimage-extract-and-run --cli --version 2>&1) && grep -q 'needs the GNU C library' <<<"$said"
}

# drags SUITE: the window opens on a display of its own; pulling the inside of the triangle edits the entry, which the
# asterisk in the title tells. The picture of the window, in German, stays in the folder, to be looked at.
drags() {
  local display=:77 server program window='' title=''
  Xvfb "$display" -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1 &
  server=$!
  in_suite "$1" env DISPLAY="$display" LANG=C.UTF-8 LANGUAGE=de HOME="/project/$work/home-$1" \
    "$file" ifs_library/paper.ifs >"$work/window-$1.log" 2>&1 &
  program=$!
  export DISPLAY=$display
  for _ in $(seq 120); do
    window=$(xdotool search --onlyvisible --name 'paper.ifs' 2>/dev/null | tail -n 1) && [ -n "$window" ] && break
    sleep 0.5
  done
  for _ in $(seq 20); do
    [ -n "$window" ] || break
    xdotool mousemove --sync 720 400 mousedown 1
    for step in 5 10 20 30 40; do xdotool mousemove --sync $((720 - step)) $((400 - step)); done
    xdotool mouseup 1
    title=$(xdotool getwindowname "$window")
    case "$title" in *\**) break ;; esac
    sleep 1
  done
  import -window root "$work/window-$1.png"
  kill "$program" "$server"
  wait "$program" "$server" 2>/dev/null || true
  case "$title" in *\**) return 0 ;; *) return 1 ;; esac
}

check "Debian 11 is told what is missing" says_what_is_missing
for suite in bookworm trixie; do
  check "$suite: the same picture" same_picture "$suite" "$file" --cli
  check "$suite: the same picture, unpacked" same_picture "$suite" "$file" --appimage-extract-and-run --cli
  check "$suite: from a folder with blanks and umlauts" \
    same_picture "$suite" "$work/Ordner mit Ümläuten/Bary cage.AppImage" --cli
  check "$suite: a drag in the window" drags "$suite"
done
exit "$failed"
