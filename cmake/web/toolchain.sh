#!/usr/bin/env bash
# The compiler of the page, in a folder of its own: toolchain.sh FOLDER. Debian 12's emscripten is too old for C++20,
# so that of Debian 13 runs with Debian 12's clang-19. Its binaryen needs a newer libc, which stands beside it.
# Nothing is installed, no root is needed: packages are downloaded and unpacked into FOLDER, and a second run has
# nothing to do. Sources of libraries that are only there as machine code are fetched, too.
set -euo pipefail

fail() {
    echo "dev: error: no compiler for the page: $1" >&2
    exit 2
}

[ $# -eq 1 ] || fail "toolchain.sh needs a folder"
mkdir -p "$1"
folder=$(cd "$1" && pwd)
done="$folder/.complete"
version=$(sha256sum "${BASH_SOURCE[0]}" | cut -d' ' -f1)
[ "$(cat "$done" 2>/dev/null)" != "$version" ] || exit 0

for tool in apt-get dpkg dpkg-source node python3; do
    command -v "$tool" >/dev/null || fail "$tool is not there; ./dev web installs it where apt can"
done
suite=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
[ -n "$suite" ] || fail "/etc/os-release names no suite of Debian; elsewhere install emscripten 3.1.69 and set JW_EMSCRIPTEN to its folder"
mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' | sed -n "s/ $suite\$//p" | head -n 1)
[ -n "$mirror" ] || fail "apt has no source for '$suite'"

# a package list of its own, so that the system's stays as it is: apt_of SUITE ARGS...
apt_of() {
    local lists="$folder/apt/$1" key=/usr/share/keyrings/debian-archive-keyring.gpg
    mkdir -p "$lists/lists/partial" "$folder/apt/cache/archives/partial"
    printf '%s [signed-by=%s] %s %s main\n' deb "$key" "$mirror" "$1" deb-src "$key" "$mirror" "$1" >"$lists/sources.list"
    shift
    # APT::Sandbox::User: its own user may not write into this folder
    apt-get -qq -o "Dir::Etc::sourcelist=$lists/sources.list" -o Dir::Etc::sourceparts=/dev/null \
        -o "Dir::State::lists=$lists/lists" -o "Dir::Cache=$folder/apt/cache" -o Acquire::Languages=none \
        -o "APT::Sandbox::User=$(id -un)" "$@" || fail "apt-get $1 $2 failed; is $mirror reachable?"
}

# fetch SUITE INTO PACKAGE...
fetch() {
    local from=$1 into="$folder/$2" package
    shift 2
    rm -rf "$into" "$folder/packages"
    mkdir -p "$into" "$folder/packages"
    (cd "$folder/packages" && apt_of "$from" download "$@") >&2
    for package in "$folder"/packages/*.deb; do dpkg -x "$package" "$into"; done
    rm -rf "$folder/packages"
}

echo "dev: fetching the compiler of the page, once: 330 MB, then 2 GB in $folder" >&2
rm -f "$done"
for from in "$suite" trixie; do apt_of "$from" update >&2; done
fetch trixie newer emscripten binaryen libc6 libstdc++6 libgcc-s1
fetch "$suite" own clang-19 libclang-common-19-dev libclang-cpp19 libllvm19 libclang1-19 lld-19 llvm-19 \
    llvm-19-linker-tools node-acorn
# imgui, FreeType and libdeflate as in the window, with which pictures are compared; apt has checked their signatures
rm -rf "$folder/sources"
mkdir -p "$folder/sources"
(cd "$folder/sources" && apt_of "$suite" source --download-only imgui freetype libdeflate) >&2
for name in imgui freetype libdeflate; do
    dpkg-source --no-check --extract "$folder/sources/$name"_*.dsc "$folder/sources/$name" >/dev/null || fail "cannot unpack $name"
done

# programs that start with the libraries beside them: starter FILE COMMAND...
starter() {
    local file=$1
    shift
    printf '#!/bin/sh\n%s "$@"\n' "$(printf '%q ' "$@")" >"$file"
    chmod +x "$file"
}
rm -rf "$folder/llvm" "$folder/binaryen"
mkdir -p "$folder/llvm/bin" "$folder/binaryen/bin"
machine=$(ls "$folder/newer/usr/lib" | grep -- '-linux-gnu$')
for tool in "$folder"/own/usr/lib/llvm-19/bin/*; do
    starter "$folder/llvm/bin/$(basename "$tool")" \
        env "LD_LIBRARY_PATH=$folder/own/usr/lib/llvm-19/lib:$folder/own/usr/lib/$machine" "$tool"
done
loader=$(ls "$folder/newer/usr/lib/$machine"/ld-linux-*.so.*)
for tool in "$folder"/newer/usr/bin/wasm*; do
    starter "$folder/binaryen/bin/$(basename "$tool")" \
        "$loader" --library-path "$folder/newer/usr/lib/$machine" "$tool"
done

# emscripten asks Node for acorn, which Debian keeps in a folder of its own
emscripten="$folder/newer/usr/share/emscripten"
mkdir -p "$emscripten/node_modules"
ln -sfn "$folder/own/usr/share/nodejs/acorn" "$emscripten/node_modules/acorn"
cat >"$folder/emscripten.config" <<TXT
EMSCRIPTEN_ROOT = '$emscripten'
LLVM_ROOT = '$folder/llvm/bin'
BINARYEN_ROOT = '$folder/binaryen'
NODE_JS = '$(command -v node)'
CACHE = '$folder/cache'
FROZEN_CACHE = False
TXT
ln -sfn "$emscripten" "$folder/emscripten"
echo "$version" >"$done"
