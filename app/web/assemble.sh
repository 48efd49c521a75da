#!/usr/bin/env bash
# The page as a folder of static files: assemble.sh BUILT NPM INTO. BUILT has jointwise.js, .wasm and .data, NPM the
# packages of npm/package.json.
set -euo pipefail

built=$1 npm=$2 into=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

rm -rf "$into.new"
mkdir -p "$into.new"
cp "$here"/page/* "$into.new"
cp "$built"/jointwise.js "$built"/jointwise.wasm "$built"/jointwise.data "$into.new"
node "$here/bundle_lessons.mjs" "$here/../../lessons" >"$into.new/lessons.json"
(cd "$npm" && ./node_modules/.bin/esbuild text_editor.js --bundle --format=esm --minify --log-level=warning --outfile="$into.new/text_editor.js")

# One version for all files, made of what is in them: a page of one version never runs a program of another. Names in
# byte order, so that the version is the same on every machine.
cd "$into.new"
version=$(LC_ALL=C; for file in *; do sha256sum "$file"; done | sha256sum | cut -c1-16)
# letters of some languages only are fetched when they are needed
cp /usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf chinese.ttf
names=$(LC_ALL=C; printf '"%s",' * | sed -e 's/"chinese.ttf",//' -e 's/,$//')
sed -e "s/@VERSION@/$version/" -e "s|\"@FILES@\"|$names|" service_worker.js >service_worker.new
mv service_worker.new service_worker.js
sed -i "s/@VERSION@/$version/" index.html
cd ..
rm -rf "$into"
mv "$into.new" "$into"
