#!/usr/bin/env bash
# The page as a folder of static files: assemble.sh BUILT NPM TOOLCHAIN INTO. BUILT has jointwise.js, .wasm and .data, NPM
# the packages of npm/package.json, the scripts beside it and lesson.schema.json, TOOLCHAIN the compiler (cmake/web/toolchain.sh).
set -euo pipefail

built=$1 npm=$2 toolchain=$3 into=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# notice NAME FILE: what a project says of its copyright
notice() { printf '\n\n==== %s ====\n\n' "$1" && cat "$2"; }

# copyrights of all that the page contains: the program, libraries and fonts of Debian's packages, the compiler's own
# libraries, and packages of npm
notices() {
    local package folder
    cat "$here/../../LICENSE"
    for package in libeigen3-dev libimgui-dev libstb-dev nlohmann-json3-dev libfmt-dev libtomlplusplus-dev libdeflate-dev \
        libfreetype-dev fonts-dejavu-core fonts-lmodern fonts-droid-fallback; do
        notice "$package" "/usr/share/doc/$package/copyright"
    done
    notice emscripten "$toolchain/newer/usr/share/doc/emscripten/copyright"
    for folder in $(cd "$npm" && npm ls --omit=dev --all --parseable | tail -n +2); do
        notice "${folder##*/node_modules/}" "$folder/LICENSE"
    done
}

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
# fetched only when they are needed: letters of some languages, and notices
cp /usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf chinese.ttf
notices >notices.txt
names=$(LC_ALL=C; printf '"%s",' * | sed -e 's/"chinese.ttf",//' -e 's/"notices.txt",//' -e 's/,$//')
sed -e "s/@VERSION@/$version/" -e "s|\"@FILES@\"|$names|" service_worker.js >service_worker.new
mv service_worker.new service_worker.js
sed -i "s/@VERSION@/$version/" index.html
cd ..
rm -rf "$into"
mv "$into.new" "$into"
