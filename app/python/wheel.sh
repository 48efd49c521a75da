#!/usr/bin/env bash
# A wheel of the module that was built, from Debian's packages alone: wheel.sh CMAKE SOURCES BUILD VERSION PYTHON FOLDER.
# It has the lessons in it, and the libraries that other systems have in other versions, as the tarball does.
set -euo pipefail

cmake=$1 sources=$2 build=$3 version=$4 python=$5 out=$6
stage=$(mktemp -d)
trap 'rm -rf "$stage"' EXIT

"$cmake" --install "$build" --prefix "$stage" --component python --strip >/dev/null
cp "$sources/app/python/setup.py" "$stage"
cd "$stage"
# the same files give the same wheel, whenever it is packed
JW_VERSION=$version SOURCE_DATE_EPOCH=315532800 PYTHONDONTWRITEBYTECODE=1 \
    "$python" setup.py -q bdist_wheel --dist-dir "$out" 2>log || { cat log >&2; exit 1; }
