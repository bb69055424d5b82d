#!/usr/bin/env bash
# Installs by cargo-c into build/cargo-c/stage, and runs the tests of `make install` on it.
#   check-cargo-c.sh [packages to install first]
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install-packages.sh "$@"

# The release for Rust 1.95.
cargo_c=0.10.24
work=$PWD/build/cargo-c
stage=$work/stage/usr/local
[[ $("$work/bin/cargo-cinstall" --version 2>/dev/null) == *" $cargo_c"* ]] ||
  CARGO_TARGET_DIR=$work/target cargo install cargo-c --version "$cargo_c" --locked --root "$work"
rm -rf "$work/stage"
# Debian's cargo-c puts libraries into a folder for the architecture; here both installations have one layout.
PATH=$work/bin:$PATH cargo cinstall --release --locked --prefix /usr/local --libdir lib --destdir "$work/stage"

cpp_tests/consumer/library.sh "$stage" include/gusset.symbols
# Its pkg-config file names the final prefix; pkg-config reads it with the staging prefix.
package="PKG_CONFIG_LIBDIR='$stage/lib/pkgconfig' pkg-config --define-prefix gusset"
field() { sed -nE "s/^$1: *//p" "$2" | tr -s ' '; }
for name in Name Description Version; do
  diff <(field "$name" "$stage/lib/pkgconfig/gusset.pc") \
    <(sed "s|@VERSION@|$(eval "$package --modversion")|; s|@DESCRIPTION@|$(sed -n 's/^description = "\(.*\)"/\1/p' Cargo.toml)|" \
      packaging/gusset.pc.in | field "$name" /dev/stdin)
done
# Only our pkg-config file has linker flags: cargo-c names libraries.
words() { tr ' ' '\n' | sed '/^$/d; /^-Wl,/d' | sort -u; }
diff <(field Libs.private "$stage/lib/pkgconfig/gusset.pc" | words) <(field Libs.private packaging/gusset.pc.in | words)
mkdir -p "$work/pkg_config" && make --always-make -C "$work/pkg_config" -f "$PWD/cpp_tests/consumer/pkg_config/Makefile" \
  PREFIX="$stage" "package=$package"
rm -rf "$work/find_package"
ctest --build-and-test cpp_tests/consumer/find_package "$work/find_package" --build-generator 'Unix Makefiles' \
  --build-options "-DCMAKE_PREFIX_PATH=$stage" "-DEXPECTED=$stage" --test-command ctest --output-on-failure
echo "cargo-c: $stage is a good installation"
