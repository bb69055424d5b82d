#!/usr/bin/env bash
# make check-conan: makes packages of the recipe in $1 by conan, with the shared and with the static library, and builds a program with
# each. Conan comes from PyPI into build/conan, with its own home.
set -euo pipefail
cd "$(dirname "$0")/.."
recipe=$1 conan=2.34.0 work=$PWD/build/conan
scripts/install-packages.sh cmake g++ python3-venv
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)

if [ "$("$work/venv/bin/conan" --version 2>/dev/null)" != "Conan version $conan" ]; then
  echo "gusset: about to install conan $conan from PyPI into build/conan/venv"
  rm -rf "$work/venv"
  python3 -m venv "$work/venv"
  "$work/venv/bin/pip" install -q --disable-pip-version-check "conan==$conan" >"$work/log" 2>&1 ||
    { tail -n 5 "$work/log"; echo "gusset: conan cannot be installed for $(python3 --version)" >&2; exit 1; }
fi
# Hides Rust, even if this machine has it.
mkdir -p "$work/no_rust"
ln -sf "$PWD/cpp_tests/consumer/no_rust.sh" "$work/no_rust/cargo"
ln -sf "$PWD/cpp_tests/consumer/no_rust.sh" "$work/no_rust/rustc"
export PATH=$work/no_rust:$PATH CONAN_HOME=$work/home
rm -rf "$CONAN_HOME" "$work/recipe"
# Conan builds in the folder of the recipe.
cp -r "$recipe" "$work/recipe"
"$work/venv/bin/conan" profile detect 2>/dev/null
for shared in True False; do
  "$work/venv/bin/conan" create "$work/recipe" --version "$version" --no-remote --build=missing -o "gusset/*:shared=$shared" 2>&1 |
    tee "$work/log" | grep -E "options:|^ERROR|vertices" || true
  grep -qx '10 vertices, 16 faces' "$work/log" || { cat "$work/log"; echo "FAILED: shared=$shared" >&2; exit 1; }
done
echo "conan: gusset/$version with the shared and with the static library"
