#!/usr/bin/env bash
# The recipes of docs/films: parts by GNU parallel and by an array job of Slurm on this machine give the film that one
# process draws, to the byte. Slurm's daemons are started here and stopped again; without them, or without the right to
# start them, that half is left out, and a message says so. Called by ctest: clusters_test.sh PROGRAM SOURCES.
set -uo pipefail

program=$(realpath "$1") sources=$(realpath "$2")
lesson=$sources/lessons/catalogue/loops/four-bar.toml
options=(--from B --to 9 --no-panel --size 320x200 --fps 10)
folder=$(mktemp -d)
stop() {
    local file pid k pids=()
    for file in "$folder"/*.pid; do
        [ ! -e "$file" ] || pids+=("$(cat "$file")")
    done
    kill "${pids[@]}" 2>/dev/null
    for pid in "${pids[@]}"; do
        for ((k = 0; k < 100; ++k)); do
            kill -0 "$pid" 2>/dev/null || break
            sleep 0.1
        done
    done
    rm -rf "$folder"
}
trap stop EXIT
cd "$folder" || exit 1
mkdir bin
ln -s "$program" bin/jointwise
export PATH="$folder/bin:/usr/sbin:$PATH" HOME="$folder"
failures=0

fail() {
    echo "clusters test: $1"
    failures=$((failures + 1))
}

jointwise render "$lesson" --out one.gif --jobs 1 "${options[@]}" 2>log || fail "one process: $(cat log)"
# is_that_film NAME FILE
is_that_film() {
    cmp -s one.gif "$2" || fail "$1 does not give the film of one process"
    [ ! -e "$2.unfinished" ] || fail "$1 leaves something"
}
"$sources/docs/films/parallel.sh" "$lesson" parallel.gif 3 "${options[@]}" >log 2>&1 || fail "parallel: $(cat log)"
is_that_film "GNU parallel" parallel.gif
# a part that fails is reported
"$sources/docs/films/parallel.sh" "$lesson" none/x.gif 3 "${options[@]}" >log 2>&1 && fail "parallel hides a failure"

if [ "$(id -u)" -ne 0 ] || ! command -v slurmd >/dev/null || ! command -v slurmctld >/dev/null || ! command -v munged >/dev/null; then
    echo "clusters test: without Slurm: it needs root, slurm-wlm and munge"
    exit "$((failures > 0))"
fi

host=$(hostname -s)
mkdir -m 700 state spool munge
head -c 1024 /dev/urandom >munge/key
chmod 600 munge/key
cat >slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
SchedulerParameters=sched_min_interval=0,batch_sched_delay=0,bf_interval=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF=$folder/slurm.conf
munged --force --socket="$folder/munge.socket" --key-file=munge/key --pid-file="$folder/munged.pid" \
    --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" && slurmctld -c && slurmd ||
    fail "Slurm's daemons do not start: $(cat ./*.log)"
"$sources/docs/films/slurm.sh" "$lesson" slurm.gif 3 "${options[@]}" >log 2>&1 || fail "slurm: $(cat log)"
for ((k = 0; k < 600; ++k)); do
    [ -n "$(squeue --noheader 2>/dev/null)" ] || break
    sleep 0.2
done
is_that_film Slurm slurm.gif
[ "$failures" -eq 0 ] || cat slurm.gif.slurm*.log
[ "$failures" -eq 0 ] && echo "parts make the film of one process"
exit "$((failures > 0))"
