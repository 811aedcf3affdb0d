#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#SBATCH --job-name=barycage-merge
#SBATCH --requeue
#SBATCH --open-mode=append
# Puts the parts of a picture together, once all of them are there.
#   sbatch --dependency=afterok:JOB merge.sh FOLDER OUT.png
set -euo pipefail
exec "${BARYCAGE_CLI:-barycage-cli}" merge -o "$2" -- "$1"/*.sum
