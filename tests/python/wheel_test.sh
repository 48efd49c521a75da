#!/usr/bin/env bash
# The wheel in an environment of its own: installed without a network, imported and run without build and sources.
# Called by ctest: wheel_test.sh CMAKE SOURCES BUILD VERSION PYTHON.
set -uo pipefail

cmake=$1 sources=$2 build=$3 version=$4 python=$5
folder=$(mktemp -d)
trap 'wait; rm -rf "$folder"' EXIT
unset PYTHONPATH JOINTWISE_LESSONS
failures=0

fail() {
    echo "wheel test: $1"
    failures=$((failures + 1))
}

"$sources/app/python/wheel.sh" "$cmake" "$sources" "$build" "$version" "$python" "$folder/wheels" || exit 1
wheel=$(echo "$folder"/wheels/jointwise-"$version"-cp*-linux_*.whl)
[ -f "$wheel" ] || { fail "there is no wheel for this Python: $(ls "$folder/wheels")"; exit 1; }

# builds it once more, while the first is tested
"$sources/app/python/wheel.sh" "$cmake" "$sources" "$build" "$version" "$python" "$folder/again" &
again=$!

# numpy is the system's; where Debian's pip can run from its own wheel, it is not unpacked, which takes seconds
pip=$(echo /usr/share/python-wheels/pip-*.whl)
if [ -f "$pip" ]; then
    "$python" -m venv --system-site-packages --without-pip "$folder/venv" || exit 1
    pip=("$folder/venv/bin/python" "$pip/pip")
else
    "$python" -m venv --system-site-packages "$folder/venv" || exit 1
    pip=("$folder/venv/bin/pip")
fi
"${pip[@]}" install --quiet --no-index --no-deps "$wheel" || exit 1
package=$(echo "$folder"/venv/lib/python3*/site-packages/jointwise)

# nothing in it names where it was built
named=$(grep -rlF -e "$sources" -e "$build" "$package")
[ -z "$named" ] || fail "these name the build or the sources: $named"
ldd "$package"/_jointwise*.so >"$folder/libraries"
for name in fmt tomlplusplus deflate gif; do
    grep -q "lib$name[.]so[^ ]* => $package/libs/" "$folder/libraries" || fail "the wheel lacks lib$name"
done
# the check notices missing ones
mv "$package/libs" "$folder/aside"
ldd "$package"/_jointwise*.so | grep -q " => $package/libs/" && fail "libraries are found where none are"
mv "$folder/aside" "$package/libs"
for file in py.typed __init__.pyi; do [ -e "$package/$file" ] || fail "the wheel lacks $file"; done
for kind in catalogue exercises benchmark reference; do
    diff -rq "$sources/lessons/$kind" "$package/share/jointwise/lessons/$kind" || fail "other files in $kind"
done

# copyright of the linked libraries
for name in copyright third-party/libeigen3-dev third-party/libfmt-dev third-party/pybind11-dev; do
    [ -s "$package/share/doc/jointwise/$name" ] || fail "the wheel lacks the copyright $name"
done

wait "$again" || exit 1
cmp "$wheel" "$folder/again/$(basename "$wheel")" || fail "the same files give another wheel"

cd "$folder" || exit 1
"$folder/venv/bin/python" - "$folder" <<'PYTHON' || fail "the installed module does not run"
import sys
from pathlib import Path

import jointwise as jw

assert Path(jw.__file__).is_relative_to(sys.argv[1]), jw.__file__
lesson = jw.read_lesson(jw.lesson_file("loops/four-bar"))
assert str(jw.lesson_file("loops/four-bar")).startswith(sys.argv[1])
pose = jw.assemble(lesson.mechanism)
assert jw.rank_at(lesson.mechanism, pose).redundant == 3
assert len(jw.follow(lesson.mechanism, lesson.motion_times)) == len(lesson.motion_times)
assert jw.draw(lesson, pose, 64, 48).png().startswith(b"\x89PNG")
PYTHON

[ "$failures" -eq 0 ] && echo "the wheel is installed and runs"
exit "$((failures > 0))"
