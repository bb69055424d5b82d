#!/usr/bin/env bash
# Compares the binary interface with its baseline.
#   abi.sh check INCLUDE      compares; INCLUDE holds the headers, and gusset.symbols or is beside share/gusset
#   abi.sh baseline INCLUDE   writes the baseline of this SONAME, and the symbols file of the Debian package
#
# The rule: within one SONAME the interface only grows. Existing items keep their names, signatures, layouts and
# values; new functions and constants may be added. Any other change needs a new SONAME, and so a new minor version in
# Cargo.toml.
#
# The interface is read from the headers, as C programs see it. Tests keep the headers equal to the sources, and the
# list of symbols equal to the library. (Rust's debug data use Rust names, which change where C programs see no
# change.)
# Functions get empty bodies, and constants become variables of their own types, because abidw reads compiled items
# only.
set -euo pipefail
verb=$1 include=$2
root=$(cd "$(dirname "$0")/../.." && pwd)
symbols=$include/gusset.symbols
[ -e "$symbols" ] || symbols=$include/../share/gusset/gusset.symbols
version=$(sed -n 's/^#define GUSSET_VERSION_STRING "\(.*\)"/\1/p' "$include/gusset/base.h")
soname=libgusset.so.${version%.*}
baseline=$root/packaging/abi/$soname.xml
debian=$root/packaging/debian/libgusset${version%.*}.symbols
# Types have the sizes of this machine.
[ "$(uname -m)" = x86_64 ] || { echo "SKIPPED: the baseline is for x86_64"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# In the order in which gusset.h includes them, without inline functions.
parts=$(sed -n 's|^#include "\(gusset/.*\)"|\1|p' "$include/gusset.h" | grep -v views.h)
for header in $parts gusset_plugin.h; do
  sed -E '/^#include "/d; /^GUSSET_[A-Z_]*API/ { :more; /;$/! { N; b more }; s/\);$/) { __builtin_trap(); }/ }' "$include/$header"
  sed -nE '/GUSSET_VERSION_/d; s/^(#define|   ) (GUSSET_[A-Z0-9_]+) (= )?(0x)?[0-9A-F]+,?$/enum the_\2 { value_of_\2 = \2 } the_\2;/p' \
    "$include/$header"
done >"$work/interface.c"
# The baseline does not include the build folder.
(cd "$work" && gcc -std=c17 -w -g -shared -fPIC -nostdlib "-Wl,-soname,$soname" interface.c -o "$soname")
functions=$(nm -D --defined-only "$work/$soname" | awk '$2 == "T" { print $3 }' | LC_ALL=C sort)
diff <(echo "$functions") <(LC_ALL=C sort "$symbols") || { echo "FAILED: the headers do not declare what $symbols lists" >&2; exit 1; }
abidw --no-corpus-path --no-comp-dir-path --no-show-locs --no-elf-needed --no-parameter-names --type-id-style hash \
  "$work/$soname" >"$work/now.xml"

compare() { abidiff "$@" "$baseline" "$work/now.xml" >"$work/report"; }
state=same
if [ ! -e "$baseline" ]; then
  state=new
elif ! compare; then
  state=grown
  compare --no-added-syms || state=broken
fi

# Symbols that the list of the Debian package lacks, with the version that adds them.
unlisted() {
  grep -vxFf <(sed -nE 's/^ (\S+)@Base .*/\1/p' "$debian" 2>/dev/null) "$symbols" || true
}

case $verb-$state in
  check-same)
    [ -z "$(unlisted)" ] || { echo "FAILED: $debian lacks symbols; write it: make abi-baseline" >&2; exit 1; }
    echo "$soname: $(wc -l <"$symbols") functions as in the baseline" ;;
  check-new) echo "FAILED: $soname has no baseline yet; write it: make abi-baseline" >&2; exit 1 ;;
  check-grown)
    compare || cat "$work/report"
    echo "FAILED: the interface of $soname has grown, which it may; write the new baseline: make abi-baseline" >&2; exit 1 ;;
  baseline-broken | check-broken)
    cat "$work/report"
    if [ "$verb" = check ] || [ "${UNRELEASED:-}" != 1 ]; then
      echo "FAILED: programs built against the baseline of $soname would break. Undo the change; or give the library a new SONAME by a new
minor version in Cargo.toml, and then: make abi-baseline. Only if no release ever had this SONAME: make abi-baseline UNRELEASED=1" >&2
      exit 1
    fi ;;&
  baseline-*)
    cp "$work/now.xml" "$baseline"
    [ -e "$debian" ] || echo "$soname libgusset${version%.*} #MINVER#" >"$debian"
    { head -n 1 "$debian"
      { tail -n +2 "$debian" | grep -E "^ ($(paste -sd'|' "$symbols"))@" || true; unlisted | sed "s/.*/ &@Base $version/"; } | LC_ALL=C sort
    } >"$work/debian"
    cp "$work/debian" "$debian"
    echo "wrote packaging/abi/$soname.xml and ${debian#"$root"/} ($state)" ;;
esac
