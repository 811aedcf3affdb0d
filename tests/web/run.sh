#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Everything about web pages that needs node or a browser: the types of their modules, the list of hashes with the
# engine of the browser, and pages and the site of the documentation in Chromium. ./dev test --web calls it.
#   run.sh BARYCAGE_CLI FOLDER   (which keeps what npm brings)
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
BARYCAGE_CLI=$(readlink -f "$1")
mkdir -p "$2"
kept=$(readlink -f "$2")
BARYCAGE_NODE_MODULES=$kept/node_modules
export BARYCAGE_CLI BARYCAGE_NODE_MODULES
for program in node npm chromedriver; do
  command -v "$program" >/dev/null || { printf 'run.sh: %s was not found\n' "$program" >&2; exit 1; }
done
cp "$here"/package.json "$here"/package-lock.json "$here"/.npmrc "$kept"
(cd "$kept" && npm ci --no-fund --no-audit --silent)
"$BARYCAGE_NODE_MODULES"/.bin/tsc -p "$here/tsconfig.json"
for engine in "$here"/../../app/web/built/*.wasm.gz; do node "$here/hashes.mjs" "$engine"; done
for tests in "$here"/*_test.mjs; do node --test "$tests"; done
