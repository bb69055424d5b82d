#!/usr/bin/env bash
# make check-deb: runs the tests of the Debian packages in build/deb by autopkgtest. They are installed on this machine for it, and removed
# afterwards.
#   check-deb.sh [packages to install first]
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install-packages.sh "$@"
[ "$(id -u)" -eq 0 ] || { echo 'gusset: the packages are installed for this: run it as root, in a container say' >&2; exit 1; }
packages=(build/deb/*.deb)
mapfile -t names < <(for package in "${packages[@]}"; do dpkg-deb -f "$package" Package; done)
# Unknown packages are not a failure.
installed() { { dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${names[@]}" 2>/dev/null || true; } | sed -n 's/^installed //p'; }
there=$(installed)
[ -z "$there" ] || { echo "gusset: installed already, and not to be replaced: $there" >&2; exit 1; }
trap 'apt-get purge -y -q $(installed) >/dev/null 2>&1 || true' EXIT
tree=build/deb/gusset-$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
status=0
autopkgtest --quiet "${packages[@]}" "$tree/" -- null || status=$?
exit "$status"
