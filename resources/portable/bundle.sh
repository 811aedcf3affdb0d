#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# bundle.sh BUILD FOLDER: an installed tree with all its libraries, which runs where it is unpacked.
#
# BUILD is a finished build on this machine. What it links is copied into FOLDER/lib and found by paths relative to the
# programs. glibc, libstdc++ and libgcc remain those of the system, which has the newer ones of the two.
set -euo pipefail
build=$1 folder=$2
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
libraries=/usr/lib/$(gcc -print-multiarch)
plugins=$libraries/qt6/plugins
fonts=/usr/share/fonts/truetype/dejavu

wanted=(platforms/libq{xcb,wayland-generic,wayland-egl,offscreen,minimal}.so
  iconengines/libqsvgicon.so imageformats/libq{svg,jpeg,gif,ico}.so
  platforminputcontexts/lib{compose,ibus}platforminputcontextplugin.so
  platformthemes/libqxdgdesktopportal.so printsupport/libcupsprintersupport.so
  xcbglintegrations/libqxcb-{glx,egl}-integration.so
  wayland-shell-integration/libxdg-shell.so wayland-decoration-client/libbradient.so
  wayland-graphics-integration-client/libqt-plugin-wayland-egl.so)
# Of glibc and the compiler: what the system has is at least as new, and must fit its own parts.
ours='^(ld-linux.*|lib(c|m|dl|pthread|rt|resolv|util|nss_.*|anl|mvec|BrokenLocale|stdc\+\+|gcc_s))\.so'

rm -rf "$folder"
DESTDIR=$folder cmake --install "$build" --prefix / --strip >/dev/null
mkdir -p "$folder"/{lib,libexec,translations,etc/fonts,share/fonts,share/doc/barycage/licences}
mv "$folder"/bin/* "$folder/libexec"
for plugin in "${wanted[@]}"; do
  mkdir -p "$folder/plugins/${plugin%/*}"
  cp "$plugins/$plugin" "$folder/plugins/$plugin"
done
cp /usr/share/qt6/translations/qtbase_{de,es,fr}.qm "$folder/translations"
cp "$fonts"/DejaVuSans{,-Bold,-Oblique,Mono}.ttf "$folder/share/fonts"
cp "$here/fonts.conf" "$folder/etc/fonts"
printf '[Paths]\nPrefix=..\nPlugins=plugins\nTranslations=translations\n' >"$folder/libexec/qt.conf"

mapfile -t plugin_files < <(find "$folder/plugins" -name '*.so')
programs=("$folder"/libexec/barycage "$folder"/libexec/barycage-cli)
names=()
while read -r library; do
  name=${library##*/}
  [[ ! $name =~ $ours ]] || continue
  cp -nL "$library" "$folder/lib/$name"
  names+=("$name")
done < <(ldd "${programs[@]}" "${plugin_files[@]}" | awk '$2 == "=>" && $3 ~ /^\// { print $3 }' | sort -u)

strip --strip-unneeded "$folder"/lib/*
# shellcheck disable=SC2016 # the loader expands it
patchelf --set-rpath '$ORIGIN' "$folder"/lib/*
# shellcheck disable=SC2016
patchelf --set-rpath '$ORIGIN/../lib' "${programs[@]}"
# shellcheck disable=SC2016
patchelf --set-rpath '$ORIGIN/../../lib' "${plugin_files[@]}"

# Two of Debian's libraries call what glibc has since 2.36 only.
g++ -O2 -shared -fPIC "$here/arc4random.cpp" -Wl,--as-needed -Wl,-soname,libbarycage-random.so -o "$folder/lib/libbarycage-random.so"
for library in "$folder"/lib/lib{cups,expat}.so.*; do
  patchelf --clear-symbol-version arc4random --clear-symbol-version arc4random_buf \
    --add-needed libbarycage-random.so "$library"
done

# The licence of everything that is bundled, by Debian's package.
mapfile -t packages < <(dpkg-query --search "${names[@]/#/*/$(gcc -print-multiarch)/}" | cut -d: -f1)
packages+=(qt6-wayland qt6-xdgdesktopportal-platformtheme fonts-dejavu-core libeigen3-dev libhwy-dev)
printf '%s\n' "${packages[@]}" | sort -u | while read -r package; do
  cp -L "/usr/share/doc/$package/copyright" "$folder/share/doc/barycage/licences/$package"
done

# The version of glibc whose functions are called, for the sentence on systems that are too old.
glibc=$(objdump -T "${programs[@]}" "$folder"/lib/* "${plugin_files[@]}" 2>/dev/null |
  grep -o 'GLIBC_[0-9.]*' | cut -d_ -f2 | sort -uV | tail -n 1)
for program in "${programs[@]##*/}"; do
  sed "s/@GLIBC@/$glibc/" "$here/start.sh" >"$folder/bin/$program"
  chmod 755 "$folder/bin/$program"
done
