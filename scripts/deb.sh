#!/usr/bin/env bash
# Builds the Debian packages of this tree in build/deb, with the toolchain on PATH; see
# packaging/debian/README.source.
#   deb.sh [packages to install first]
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install-packages.sh "$@"

version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
package=libgusset${version%.*}
debian=packaging/debian
grep -q "^Package: $package\$" $debian/control && [ -e "$debian/$package.install" ] && [ -e "$debian/$package.symbols" ] &&
  [[ $(dpkg-parsechangelog -l $debian/changelog -S Version) == "$version"-* ]] ||
  { echo "$debian does not package version $version as $package: see $debian/README.source" >&2; exit 1; }

work=build/deb/gusset-$version
rm -rf build/deb
mkdir -p "$work"
tar -c --exclude-vcs --exclude=./build --exclude=target --exclude=./packaging/debian . | tar -x -C "$work"
cp -r $debian "$work/debian"
cd "$work"
mkdir .cargo
cargo vendor --locked vendor >.cargo/config.toml
env -u CARGO_TARGET_DIR -u MAKELEVEL -u MAKEFLAGS dpkg-buildpackage -b -us -uc -d
cd ..
lintian --info --fail-on error gusset_*.changes
ls -l ./*.deb
