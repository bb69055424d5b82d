#!/usr/bin/env bash
# make wasm: builds the package wasm/ with gusset.wasm and gusset_files.wasm, checks its generated files against
# wasm/generate.mjs, and runs its tests under node beside the native library. Arguments: the installation of the native
# library; "build" to stop after building.
#
# The compiler is cargo's own if it has the target wasm32-unknown-unknown (rustup target add). Otherwise it is
# Debian's compiler for browsers, which has the sources of the standard library. It is unpacked into build/wasm,
# because its packages would replace rustc. RUSTC_BOOTSTRAP lets it build these sources; gusset uses no unstable
# feature.
set -euo pipefail
cd "$(dirname "$0")/.."
stage=$1 until=${2:-test}
out=$PWD/build/wasm target=wasm32-unknown-unknown
cargo=${CARGO:-cargo}
mkdir -p "$out"

flags=()
if [ -d "$(rustc --print sysroot 2>/dev/null)/lib/rustlib/$target/lib" ]; then
  remapped="--remap-path-prefix=$(rustc --print sysroot)=/rust"
else
  depends() { apt-cache depends --important "$1" 2>/dev/null | sed -n 's/^ *Depends: //p'; }
  std=$(depends libstd-rust-web-dev | grep -m 1 '^libstd-rust-web-[0-9]' || true)
  if [ -z "$std" ]; then
    echo "gusset: there is no compiler for $target: rustup target add $target, or Debian's packages rustc-web and rust-web-src" >&2
    exit 3
  fi
  # The libraries of these packages replace no other package.
  mapfile -t shared < <({ depends "$std"; depends cargo-web; } | grep '^lib' | grep -v '^libstd-rust' | sort -u)
  scripts/install-packages.sh lld-19 "${shared[@]}"
  toolchain=$out/toolchain version=$(apt-cache policy rustc-web | sed -n 's/^ *Candidate: //p')
  if [ "$(cat "$toolchain/version" 2>/dev/null)" != "$version" ]; then
    echo "gusset: about to unpack Debian's rustc-web $version into build/wasm/toolchain"
    rm -rf "$toolchain" && mkdir -p "$toolchain"
    (cd "$toolchain" && apt-get download -q rustc-web cargo-web rust-web-src libstd-rust-web-dev "$std" 2>log || { cat log >&2; exit 1; })
    for package in "$toolchain"/*.deb; do dpkg -x "$package" "$toolchain"; done
    rm "$toolchain"/*.deb
    printf '%s\n' "$version" >"$toolchain/version"
  fi
  cargo=$toolchain/usr/bin/cargo
  export RUSTC=$toolchain/usr/bin/rustc RUSTC_BOOTSTRAP=1 LD_LIBRARY_PATH=$toolchain/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH 2>/dev/null || echo x86_64-linux-gnu)
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER=wasm-ld-19
  flags=(-Z build-std=std,panic_abort)
  remapped="--remap-path-prefix=$toolchain=/rust"
fi

# Builds a package as a module, and installs it. Further arguments go to cargo. A separate folder, because this compiler
# may differ from the compiler of target. Strips the names of functions, a third of the file.
build() {
  CARGO_PROFILE_RELEASE_STRIP=true "$cargo" rustc --locked -p "$1" --lib --crate-type cdylib --release --target "$target" \
    --target-dir "$out/target" "${flags[@]}" "${@:2}" \
    --config "build.rustflags=[\"$remapped\", \"--remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=/cargo\", \"--remap-path-prefix=$PWD=/gusset\"]"
  local file=${1//-/_}.wasm
  # A running test keeps reading the old file.
  install -m 644 "$out/target/$target/release/$file" "wasm/$file"
  echo "gusset: wasm/$file has $(stat -c %s "wasm/$file") bytes, $(gzip -9 -c "wasm/$file" | wc -c) compressed by gzip"
}
build gusset --features reserve
build gusset-files --features reserve
install -m 644 LICENSE-* wasm
unset LD_LIBRARY_PATH
[ "$until" = build ] && exit 0

command -v node >/dev/null || scripts/install-packages.sh nodejs
if [ -n "${GUSSET_UPDATE:-}" ]; then
  node wasm/generate.mjs tables
  node wasm/generate.mjs types
fi
node wasm/generate.mjs tables --check
node wasm/generate.mjs types --check
${CC:-cc} -O1 -Wall -Wextra -Werror -std=c11 -D_POSIX_C_SOURCE=199309L -I "$stage/include" wasm/test/native.c -o "$out/native" -L "$stage/lib" -lgusset -Wl,-rpath,"$stage/lib"
GUSSET_NATIVE=$out/native node --test wasm/test/bytes.test.mjs wasm/test/calls.test.mjs wasm/test/files.test.mjs
node examples/wasm/first.mjs
node examples/wasm/files.mjs
