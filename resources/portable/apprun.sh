#!/bin/sh
# SPDX-License-Identifier: MIT
# What the one file starts: the window, or with --cli the command line. Also for links named barycage-cli.
case "${ARGV0##*/}" in barycage-cli) set -- --cli "$@" ;; esac
if [ "${1:-}" = --cli ]; then
  shift
  exec "$APPDIR/bin/barycage-cli" "$@"
fi
exec "$APPDIR/bin/barycage" "$@"
