#!/usr/bin/env bash
# Other programs built against an installed tree that has been moved: docs/library as it stands.
# Called by ctest: library_test.sh CMAKE SOURCES BUILD CXX.
set -uo pipefail

cmake=$1 sources=$2 build=$3 cxx=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
failures=0
export CXX=$cxx

fail() {
    echo "library test: $1"
    failures=$((failures + 1))
}
# must NAME COMMAND...
must() {
    local name=$1
    shift
    "$@" >"$folder/log" 2>&1 || { fail "$name"; cat "$folder/log"; exit 1; }
}

must install "$cmake" --install "$build" --prefix "$folder/first"
mv "$folder/first" "$folder/moved"
tree=$folder/moved
# nothing of the project but the installed tree and the two programs
cp -r "$sources/docs/library" "$folder/consumer"
configure() { "$cmake" -S "$folder/consumer" -B "$folder/$1" -G Ninja -DCMAKE_PREFIX_PATH="$tree" "${@:2}"; }
must configure configure build -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="-Wall -Wextra -Wpedantic -Werror"
must "build of the examples" "$cmake" --build "$folder/build"

cd "$folder" || exit 1
./build/four_bar "$tree/share/jointwise/lessons/catalogue/loops/four-bar.toml" >out || fail "four_bar failed"
grep -qF '21 equations, rank 18, 3 redundant:' out || { fail "four_bar says another rank"; cat out; }
grep -qF 'Jacobian 21 x 18, largest |Phi| below 1e-12' out || { fail "four_bar says another Jacobian"; cat out; }
for picture in four_bar.png lesson.png; do
    cmp -s <(head -c 8 "$picture") <(printf '\x89PNG\r\n\x1a\n') || fail "$picture is no picture"
done
./build/pendulum >pendulum.out || fail "pendulum lost its energy"

# a program that would allocate memory differently from the library is refused, with advice
must "configure for AVX" configure wide -DCMAKE_CXX_FLAGS=-mavx
if "$cmake" --build "$folder/wide" --target pendulum >log 2>&1; then fail "a program for AVX was compiled"; fi
grep -q 'build Jointwise with the same flags' log || { fail "another reason to refuse AVX"; cat log; }

# another version is refused
sed -i 's/find_package(jointwise 1.0/find_package(jointwise 9.0/' consumer/CMakeLists.txt
if configure refused >log 2>&1; then fail "version 9.0 was found"; fi
grep -q 'jointwise-config.cmake, version:' log || { fail "another reason to refuse version 9.0"; cat log; }

# the page shows the program that was built
awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$sources/docs/library.md" >shown
diff <(cat shown) "$sources/docs/library/four_bar.cpp" >difference ||
    { fail "docs/library.md shows another program than docs/library/four_bar.cpp"; cat difference; }

[ "$failures" -eq 0 ] && echo "other programs are built and run"
exit "$((failures > 0))"
