#!/bin/sh
# Draws a lesson in parts with GNU parallel, on this machine or on those of --sshloginfile in PARALLEL:
# parallel.sh LESSON OUT PARTS [OPTION OF RENDER]...
set -eu
lesson=$1 out=$2 parts=$3
shift 3
seq "$parts" | parallel --halt now,fail=1 --quote \
    jointwise render "$lesson" --out "$out" --jobs 1 --shard "{}/$parts" "$@"
jointwise render "$lesson" --out "$out" --resume "$@"
