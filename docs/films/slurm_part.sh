#!/bin/sh
# One job of slurm.sh: a part, or in the end what puts all parts together.
set -eu
if [ -n "${SLURM_ARRAY_TASK_ID:-}" ]; then
    exec jointwise render "$LESSON" --out "$OUT" --jobs 1 --shard "$SLURM_ARRAY_TASK_ID/$PARTS" "$@"
fi
exec jointwise render "$LESSON" --out "$OUT" --resume "$@"
