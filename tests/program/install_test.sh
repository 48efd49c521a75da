#!/usr/bin/env bash
# The program from an installed tree: moved, started from elsewhere and by a link, without the build and the sources.
# Called by ctest: install_test.sh CMAKE SOURCES BUILD.
set -uo pipefail

cmake=$1 sources=$2 build=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
unset JOINTWISE_LESSONS
export XDG_STATE_HOME="$folder/state"
failures=0

fail() {
    echo "install test: $1"
    failures=$((failures + 1))
}

"$cmake" --install "$build" --prefix "$folder/first" >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }

# names_of_trees FOLDER: files below it that name the sources or the build
names_of_trees() { grep -rlF -e "$sources" -e "$build" "$1"; }
found=$(names_of_trees "$folder/first")
[ -z "$found" ] || fail "these name the build or the sources: $found"
# the search does find such a name
cp "$build/CMakeCache.txt" "$folder/first/planted"
[ "$(names_of_trees "$folder/first")" = "$folder/first/planted" ] || fail "a planted name was not found"
rm "$folder/first/planted"

others=$(find "$folder/first" -mindepth 1 -maxdepth 1 ! -name bin ! -name share ! -name include ! -name lib)
[ -z "$others" ] || fail "not of the hierarchy of file systems: $others"

mkdir "$folder/elsewhere"
mv "$folder/first" "$folder/second tree"
tree="$folder/second tree"
cd "$folder/elsewhere" || exit 1
ln -s "$tree/bin/jointwise" linked
shipped=$(cd "$sources/lessons/catalogue" && find . -name '*.toml' ! -name course.toml | wc -l)
for program in "$tree/bin/jointwise" ./linked; do
    "$program" list --format json >list.json || fail "$program list"
    listed=$(grep -cF "/second tree/share/jointwise/lessons/catalogue/" list.json)
    [ "$listed" -eq "$shipped" ] || fail "$program lists $listed of its $shipped lessons"
done
./linked check "$tree/share/jointwise/lessons/catalogue/loops/four-bar.toml" >out || fail "check: $(cat out)"
./linked render "$tree/share/jointwise/lessons/catalogue/loops/four-bar.toml" --out frames --size 960x540 \
    --frames 0 2>err || fail "render: $(cat err)"
cmp -s <(head -c 8 frames/*.png) <(printf '\x89PNG\r\n\x1a\n') || fail "render wrote no picture"

# ./dev package builds everything that is installed
ninja -C "$build" -t commands jw_installed >commands || fail "ninja knows no jw_installed"
for built in "$tree"/bin/* "$tree"/lib/*.a; do
    grep -qF "/$(basename "$built") " commands || fail "$(basename "$built") is installed, and jw_installed does not build it"
done

# packages take the place of earlier ones, and leave a wheel
mkdir "$folder/packages"
touch "$folder/packages/jointwise-0.0-linux.tar.gz" "$folder/packages/jointwise.whl"
"$sources/cmake/packages.sh" "${cmake%cmake}cpack" "$build" "$folder/packages" TGZ || fail "cpack"
[ -e "$folder/packages/jointwise.whl" ] || fail "packages have deleted a wheel"
[ ! -e "$folder/packages/jointwise-0.0-linux.tar.gz" ] || fail "an earlier package is still there"

# the tarball has the libraries in it that other systems have in other versions
mkdir "$folder/an other place"
tar xzf "$folder"/packages/*.tar.gz -C "$folder/an other place" --strip-components=1
ldd "$folder/an other place/bin/jointwise" >libraries
for name in fmt tomlplusplus stb deflate gif; do
    grep -q "lib$name[.]so[^ ]* => $folder/an other place/.*/lib/jointwise/" libraries || fail "the tarball lacks lib$name"
done
# the check notices a missing one
mv "$folder/an other place/lib/jointwise" "$folder/aside"
ldd "$folder/an other place/bin/jointwise" | grep -q "an other place/.*/lib/jointwise/" && fail "libraries are found where none are"
mv "$folder/aside" "$folder/an other place/lib/jointwise"
listed=$("$folder/an other place/bin/jointwise" list --format json | grep -cF "/an other place/share/jointwise/lessons/catalogue/")
[ "$listed" -eq "$shipped" ] || fail "the program of the tarball lists $listed of its $shipped lessons"
found=$(names_of_trees "$folder/an other place")
[ -z "$found" ] || fail "these in the tarball name the build or the sources: $found"

# without its data the program says which folder it looked for
rm -r "$tree/share/jointwise"
./linked doctor --format json >out 2>&1
grep -qF "\"folder\": \"$tree/share/jointwise/lessons/catalogue\"" out && grep -qF '"state": "missing"' out ||
    fail "doctor does not name the folder that is missing"

[ "$failures" -eq 0 ] && echo "an installed tree works"
exit "$((failures > 0))"
