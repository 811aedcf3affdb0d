#!/bin/sh
# SPDX-License-Identifier: MIT
# Builds the engines of web pages into build/web. ./dev web calls it in a Debian with Emscripten, in the project.
set -eu
sources=/root/sources
mkdir -p "$sources"
if ! ls -d "$sources"/highway-*/ >/dev/null 2>&1; then
  apt-get update >&2
  (cd "$sources" && apt-get source highway >&2)
fi
highway=$(ls -d "$sources"/highway-*/)
emcmake cmake -S app/web/wasm -B build/web -G Ninja -DCMAKE_BUILD_TYPE=Release -DHIGHWAY="${highway%/}" \
  -DHASHES="$(sha256sum tests/data/hashes.txt | cut -c 1-16)" >&2
cmake --build build/web "$@" >&2
