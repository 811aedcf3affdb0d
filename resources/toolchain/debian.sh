#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs a command in another release of Debian, in a chroot that is made at the first call and kept outside the tree:
#   debian.sh SUITE PACKAGE... -- COMMAND [ARGUMENT...]
# The command starts in the folder of the project, which is mounted at /project. Root is not needed: without it,
# mmdebstrap enters a user namespace. The mirror is the one that apt uses here, with the suite replaced.
set -euo pipefail

die() { printf 'debian.sh: %s\n' "$*" >&2; exit 1; }

[ $# -ge 3 ] || die "give a suite, packages, -- and a command"
suite=$1 packages=()
shift
while [ $# -gt 0 ] && [ "$1" != -- ]; do packages+=("$1"); shift; done
[ "${1:-}" = -- ] || die "-- is missing before the command"
shift
command -v mmdebstrap >/dev/null || die "mmdebstrap was not found. Install it: apt-get install mmdebstrap"

project=$(realpath "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..")
wanted=$(printf '%s\n' "${packages[@]}" | sort -u)
kept=${XDG_CACHE_HOME:-$HOME/.cache}/barycage/$suite-$(cksum <<<"$wanted" | cut -d' ' -f1) # one for each list of packages
mkdir -p "$kept"

# The chroot is complete once the list of its packages is beside it.
exec {lock}>"$kept/lock"
flock "$lock"
if [ "$(cat "$kept/packages" 2>/dev/null)" != "$wanted" ]; then
  # shellcheck disable=SC2016 # apt's own fields
  mirror=$(apt-get indextargets --format '$(REPO_URI) $(LABEL)' | sed -n 's/ Debian$//p' | sort -u | head -n 1)
  [ -n "$mirror" ] || die "apt knows no mirror of Debian. Run apt-get update first."
  printf 'Making a chroot of Debian %s in %s (once, some minutes)\n' "$suite" "$kept" >&2
  rm -f "$kept/packages"
  mmdebstrap --quiet --variant=apt --include="$(paste -sd, <<<"$wanted")" "$suite" "$kept/new.tar" \
    "deb $mirror $suite main" "deb-src $mirror $suite main" >&2
  if [ "$(id -u)" -eq 0 ]; then
    rm -rf "$kept/root"
    mkdir "$kept/root"
    tar --extract --file "$kept/new.tar" --directory "$kept/root" --exclude='./dev/*'
  else
    [ ! -e "$kept/root" ] || mmdebstrap --unshare-helper rm -rf "$kept/root"
    # shellcheck disable=SC2016 # expanded by the inner shell
    mmdebstrap --unshare-helper sh -c 'mkdir "$2" && tar --extract --file "$1" --directory "$2" --exclude="./dev/*"' sh \
      "$kept/new.tar" "$kept/root"
  fi
  rm "$kept/new.tar"
  printf '%s\n' "$wanted" >"$kept/packages"
fi
flock --unlock "$lock"

# shellcheck disable=SC2016 # expanded by the inner shell
enter='
set -e
root=$1 project=$2
shift 2
mkdir -p "$root/project" "$root/dev" "$root/proc"
mount --make-rprivate / 2>/dev/null || true
mount --rbind /dev "$root/dev"
mount -t proc proc "$root/proc" 2>/dev/null || mount --rbind /proc "$root/proc"
mount --bind "$project" "$root/project"
exec chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
  sh -c "cd /project && exec \"\$@\"" sh "$@"'
if [ "$(id -u)" -eq 0 ]; then
  exec unshare --mount sh -c "$enter" sh "$kept/root" "$project" "$@"
fi
exec mmdebstrap --unshare-helper unshare --mount sh -c "$enter" sh "$kept/root" "$project" "$@"
