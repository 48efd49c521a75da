#!/usr/bin/env bash
# Makes packages of a build, which replace earlier ones but no wheels: packages.sh CPACK BUILD FOLDER [GENERATOR].
set -euo pipefail

cpack=$1 build=$2 folder=$3
rm -f "$folder"/*.deb "$folder"/*.tar.gz
"$cpack" --config "$build/CPackConfig.cmake" -B "$folder" ${4:+-G "$4"} >"$build/packages.log" 2>&1 || {
    cat "$build/packages.log" >&2
    exit 1
}
rm -rf "$folder/_CPack_Packages"
