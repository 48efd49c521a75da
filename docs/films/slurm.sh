#!/bin/sh
# Draws a lesson in parts as an array job of Slurm, and puts them together when all have ended. LESSON and OUT are on a
# file system that all nodes share: slurm.sh LESSON OUT PARTS [OPTION OF RENDER]...
set -eu
lesson=$(realpath "$1") out=$(realpath -m "$2") parts=$3
shift 3
# the task's number is known only where it runs
array=$(sbatch --parsable --array="1-$parts" --cpus-per-task=1 --output="$out.slurm-%a.log" --job-name=jointwise \
    --export="ALL,LESSON=$lesson,OUT=$out,PARTS=$parts" "$(dirname "$(realpath "$0")")/slurm_part.sh" "$@")
sbatch --parsable --dependency="afterany:$array" --output="$out.slurm.log" --job-name=jointwise-film \
    --export="ALL,LESSON=$lesson,OUT=$out" "$(dirname "$(realpath "$0")")/slurm_part.sh" "$@"
