#!/usr/bin/env bash
# Installs the missing Debian packages of the command line, after it has named them. It installs as root or through
# sudo; otherwise it prints the command and stops.
#
# Exit status: 0 all present, 1 could not install, 3 apt is missing (the caller may have another way).
set -euo pipefail

missing=()
for package in "$@"; do
  status=$(dpkg-query -W -f='${Status}' "$package" 2>/dev/null || true)
  [ "$status" = "install ok installed" ] || missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

if ! command -v apt-get >/dev/null 2>&1; then
  echo "gusset: these packages are needed and there is no apt-get to install them: ${missing[*]}" >&2
  exit 3
fi

run=()
if [ "$(id -u)" -ne 0 ]; then
  if command -v sudo >/dev/null 2>&1 && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
    run=(sudo)
  else
    echo "gusset: please run: sudo apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
fi

echo "gusset: about to install with apt-get: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install() { "${run[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}" >"$log" 2>&1; }
# The lists of a new machine may be missing or old: refreshes them once and tries again.
install || { "${run[@]}" apt-get update -q >>"$log" 2>&1 && install; } || {
  tail -n 20 "$log" >&2
  echo "gusset: apt-get could not install: ${missing[*]}" >&2
  exit 1
}
echo "gusset: installed ${missing[*]}"
