#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# pack.sh TREE NAME DIST: the tree that bundle.sh made as DIST/NAME.tar.xz and as one executable file, DIST/NAME.AppImage.
#
# Both are the same whenever they are made from the same tree; SOURCE_DATE_EPOCH gives the time of the files.
set -euo pipefail
tree=$1 name=$2 dist=$3
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$dist"

tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=go=rX \
  --transform "s,^\.,$name," -C "$tree" -cf - . | xz -9e -T1 >"$dist/$name.tar.xz"

mapfile -t fuse < <(pkg-config --cflags --libs fuse3 | tr ' ' '\n' | sed '/^$/d')
g++ -std=c++20 -O2 -static -s "$here/runtime.cpp" -o "$work/runtime" \
  -lsquashfuse_ll -lsquashfuse "${fuse[@]}" -llzma -lzstd -lz -llz4 -llzo2 -lpthread 2> >(grep -v 'dlopen\|fuse_get_module' >&2)
# The mark of an AppImage of type 2, in bytes of the header that are not used otherwise.
printf 'AI\002' | dd of="$work/runtime" bs=1 seek=8 conv=notrunc status=none
cp -a "$tree" "$work/tree"
install -m 755 "$here/apprun.sh" "$work/tree/AppRun"
cp "$work"/tree/share/applications/*.desktop "$work"/tree/share/icons/hicolor/scalable/apps/*.svg "$work/tree"
(cd "$work/tree" && ln -s -- *.svg .DirIcon)
mksquashfs "$work/tree" "$work/files" -comp xz -Xbcj x86 -Xdict-size 100% -b 1M -all-root \
  -noappend -quiet -no-progress
cat "$work/runtime" "$work/files" >"$dist/$name.AppImage"
chmod 755 "$dist/$name.AppImage"
(cd "$dist" && sha256sum -- * | grep -v ' SHA256SUMS$' >"$work/sums" && cp "$work/sums" SHA256SUMS)
