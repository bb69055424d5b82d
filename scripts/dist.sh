#!/usr/bin/env bash
# make dist: packs an installation into the archive $1, with its checksum. Equal sources and compilers give equal
# bytes. Beside it, conan and vcpkg get the recipes of packaging/ for the archive at the URL $2. $3: build folder of
# the program; $4: level of gzip. An archive of unchanged files is not packed again.
set -euo pipefail
cd "$(dirname "$0")/.."
archive=$1 url=${2%/} program=$3 level=$4
out=${archive%/*} file=${archive##*/}
name=${file%.tar.gz}
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)

mkdir -p "$out"
rm -rf "${out:?}/$name" "$out/conan" "$out/vcpkg"
env -u MAKELEVEL -u MAKEFLAGS make --no-print-directory -s install PREFIX="$out/$name" DESTDIR= program="$program"
cp packaging/archive/CMakeLists.txt "$out/$name"

# The time of the last commit. Without a history it is the beginning of 1980, the earliest time in some archives.
epoch=${SOURCE_DATE_EPOCH:-$([ ! -e .git ] || git log -1 --format=%ct)}
pack() {
  tar --sort=name --format=gnu --mtime="@${epoch:-315532800}" --owner=0 --group=0 --numeric-owner --mode='u=rwX,go=rX' -C "$out" -c "$name"
}
packed=$(pack | sha256sum)
if [ ! -f "$archive" ] || [ "$packed" != "$(cat "$out/packed" 2>/dev/null)" ]; then
  rm -f "$out/packed"
  pack | gzip "-${level}n" >"$archive"
  echo "$packed" >"$out/packed"
fi
(cd "$out" && sha256sum "$file" | tee "$file.sha256")
sha512=$(sha512sum "$archive" | cut -d' ' -f1)

arch=$(uname -m)
case $arch in x86_64) vcpkg=x64 ;; aarch64) vcpkg=arm64 ;; *) vcpkg=$arch ;; esac

fill() { # A template of packaging/, its name without .in
  mkdir -p "$out/$(dirname "$1")"
  sed -e "s|@VERSION@|$version|; s|@ARCH@|$arch|; s|@VCPKG_ARCH@|$vcpkg|; s|@FILE@|$file|; s|@URL@|$url/$file|; s|@SHA512@|$sha512|" \
    -e "s|@SHA256@|$(cut -d' ' -f1 "$archive.sha256")|" "packaging/$1.in" >"$out/$1"
}
cp -r packaging/conan packaging/vcpkg "$out"
cp examples/c/stitch.c "$out/conan/test_package/example.c"
find "$out/conan" "$out/vcpkg" -name '*.in' -delete
for template in conan/conandata.yml vcpkg/gusset/vcpkg.json vcpkg/gusset/portfile.cmake; do fill "$template"; done

glibc=$(find "$out/$name" -type f \( -name '*.so*' -o -path '*/bin/*' \) -exec objdump -T {} + | grep -o 'GLIBC_[0-9.]*' | sort -uV | tail -n 1)
echo "${archive#"$PWD/"}: $(du -h "$archive" | cut -f1), needs ${glibc/_/ } or later"
