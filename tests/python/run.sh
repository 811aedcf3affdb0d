#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The tests of the Python module, and the examples in its documentation. ./dev test --python calls it.
#   run.sh PYTHON FOLDER [OPTION...]   (which holds the package; the options are those of pytest)
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
PYTHONPATH=$(readlink -f "$2")
export PYTHONPATH PYTHONDONTWRITEBYTECODE=1
exec "$1" -m pytest -q -p no:cacheprovider -o doctest_optionflags='ELLIPSIS NORMALIZE_WHITESPACE' --doctest-modules \
  "$PYTHONPATH/barycage" "$here" "${@:3}"
