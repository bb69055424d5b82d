#!/usr/bin/env bash
# Makes three.min.js anew from the version of three.js that package.json names. npm holds what it fetches against the sums in
# package-lock.json. The bundle is kept here, as a machine that builds the page need have neither npm nor a network.
#   update.sh          writes it
#   update.sh --check  whether it is what would be written
set -euo pipefail
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp package.json package-lock.json parts.js "$work"
(cd "$work" && npm ci --ignore-scripts --no-audit --no-fund --silent && node_modules/.bin/esbuild parts.js --bundle --minify --format=iife \
  --global-name=THREE --target=es2022 --legal-comments=none --charset=ascii --log-level=warning --outfile=three.min.js)
cp "$work/node_modules/three/LICENSE" "$work/LICENSE.three"
for file in three.min.js LICENSE.three; do
  if [ "${1:-}" = --check ]; then
    cmp "$work/$file" "$file"
  else
    cp "$work/$file" "$file"
  fi
done
