#!/usr/bin/env bash
# The installed files as the loader and the linker see them.
#   library.sh PREFIX MANIFEST    where gusset is installed; the list of symbols in the sources
set -euo pipefail
prefix=$(realpath "$1") manifest=$(realpath "$2")
cd "$prefix/lib"
fail() { echo "FAILED: $*" >&2; exit 1; }

version=$(sed -n 's/^#define GUSSET_VERSION_STRING "\(.*\)"/\1/p' "$prefix/include/gusset/base.h")
soname=libgusset.so.${version%.*}
for link in libgusset.so "$soname"; do
  [ "$link" -ef "libgusset.so.$version" ] && [[ $(readlink "$link") == libgusset.so.* ]] ||
    fail "$link does not lead to libgusset.so.$version"
done

dynamic=$(readelf -dW "libgusset.so.$version")
grep -qF "soname: [$soname]" <<<"$dynamic" || fail "the SONAME is not $soname: $dynamic"
grep -q 'FLAGS_1.*NODELETE' <<<"$dynamic" || fail "NODELETE is missing: $dynamic"
needed=$(sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' <<<"$dynamic")
foreign=$(grep -vxE 'libc\.so\.6|libm\.so\.6|libgcc_s\.so\.1|ld-linux[a-z0-9_-]*\.so\.[0-9]+' <<<"$needed" || true)
[ -z "$foreign" ] || fail "it needs $foreign"
[ -n "$needed" ] || fail "it needs nothing, which cannot be: $dynamic"
grep -qE 'RPATH|RUNPATH' <<<"$dynamic" && fail "it looks for libraries in a folder of its own: $dynamic"

diff <(nm -D --defined-only "libgusset.so.$version" | awk '{ print $3 }' | LC_ALL=C sort) <(LC_ALL=C sort "$manifest") ||
  fail "the symbols are not those of $manifest"
cmp "$manifest" "$prefix/share/gusset/gusset.symbols" || fail 'the list installed is another'
missing=$(readelf -sW libgusset.a | awk '$5 == "GLOBAL" && $7 != "UND" { print $8 }' | LC_ALL=C sort -u |
  LC_ALL=C comm -13 - <(LC_ALL=C sort "$manifest"))
[ -z "$missing" ] || fail "the static library lacks $missing"

for file in include/gusset.hpp lib/pkgconfig/gusset.pc share/doc/gusset/{LICENSE-MIT,LICENSE-APACHE,copyright,README.md}; do
  [ -s "$prefix/$file" ] || fail "$file is missing"
done
echo "libgusset.so.$version: $(wc -l <"$manifest") symbols, needs $(tr '\n' ' ' <<<"$needed")"
