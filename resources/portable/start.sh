#!/bin/sh
# SPDX-License-Identifier: MIT
# Starts the program of this name in ../libexec with the libraries beside it.
here=$(dirname "$(readlink -f "$0")")
needed=@GLIBC@
found=$(getconf GNU_LIBC_VERSION 2>/dev/null | cut -d' ' -f2)
if [ "$(printf '%s\n%s\n' "$needed" "${found:-0}" | sort -V | head -n 1)" != "$needed" ]; then
  echo "Barycage needs the GNU C library $needed or newer, such as Debian 12, Ubuntu 22.04 or Fedora 36 have;" \
    "this system has ${found:-another one}." >&2
  exit 1
fi
if [ -z "${FONTCONFIG_FILE:-}" ] && [ ! -e /etc/fonts/fonts.conf ]; then
  export FONTCONFIG_FILE="$here/../etc/fonts/fonts.conf"
fi
exec "$here/../libexec/${0##*/}" "$@"
