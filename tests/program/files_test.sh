#!/usr/bin/env bash
# The real program with files that are not lessons, files that must not grow, and streams that are closed.
# Called by ctest: files_test.sh PROGRAM CATALOGUE.
set -uo pipefail

program=$1
four_bar=$2/loops/four-bar.toml
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export XDG_STATE_HOME="$folder/state"
failures=0

fail() {
    echo "files test: $1"
    sed 's/^/    /' err
    failures=$((failures + 1))
}

# expect STATUS TEXT NAME COMMAND...: the command ends, and not after minutes, with STATUS, and TEXT on standard error
expect() {
    local status=$1 text=$2 name=$3 got=0
    shift 3
    timeout 100 "$@" >out 2>err </dev/null || got=$?
    [ "$got" -eq "$status" ] || fail "$name: the exit status is $got, not $status"
    grep -qF -- "$text" err || fail "$name: standard error lacks: $text"
    if grep -qE '\b(E[A-Z]{4,}|GL_[A-Z]|FT_[A-Z]|CLI::|std::|toml::|Eigen::|filesystem error)' err; then
        fail "$name: a name of a library is in the message"
    fi
}
no_draft() { [ -z "$(find "${1:-.}" -name '*.part*')" ] || fail "$2 left a draft: $(find "$1" -name '*.part*')"; }

# ---- files that are not lessons
mkfifo pipe
mkdir folder.toml
ln -s loop-a loop-b
ln -s loop-b loop-a
ln -s nowhere dangling
cp "$four_bar" mine.toml
# commands that wait for a pipe run at the same time, each in a shell of its own, with files of its own
waiting=()
in_background() {
    mkdir "waits-${#waiting[@]}"
    (
        cd "waits-${#waiting[@]}" || exit 1
        failures=0
        "$@"
        exit "$failures"
    ) &
    waiting+=("$!")
}
mkfifo unwritten held
for command in step check bench; do
    in_background expect 2 "a pipe that nothing is written into" "$command of a silent pipe" "$program" $command ../unwritten
done
silent_writer() {
    exec 3<>../held
    timeout 100 "$program" step ../held >out 2>err && fail "a pipe that stays silent is read"
    grep -qF "nothing more was written into this pipe" err || fail "a pipe whose writer stays silent is not named"
}
in_background silent_writer
expect 2 "a link that leads back to itself" "a loop of links" "$program" step loop-a
expect 2 "a link to 'nowhere', and there is no such file" "a dangling link" "$program" step dangling
expect 2 "this is a folder" "a folder" "$program" step folder.toml
expect 2 "a part of the path is a file" "a file on the way" "$program" step mine.toml/x
expect 2 "there is no such file" "no file" "$program" step missing.toml
expect 2 "the name is too long" "a long name" "$program" step "$(printf 'x%.0s' {1..300})"
expect 2 "larger than 10 MB" "a device without end" "$program" step /dev/zero
expect 2 "the file is empty" "an empty device" "$program" step /dev/null
"$program" step <(cat mine.toml) >out 2>err || fail "a lesson does not come through a pipe"
(sleep 0.3; cat mine.toml) | "$program" step /dev/stdin >out 2>err || fail "a late lesson does not come through a pipe"

# ---- outputs that are inputs
cp mine.toml mine.png
ln mine.png hard.png
ln -s mine.png soft.png
for output in mine.png hard.png soft.png ./mine.png; do
    expect 2 "would be overwritten" "plot onto its lesson" "$program" plot mine.png --out $output
    expect 2 "would be overwritten" "open onto its lesson" "$program" open mine.png --picture $output
done
expect 2 "would be overwritten" "plot of a link onto what it leads to" "$program" plot soft.png --out hard.png
cp "$(dirname "$four_bar")/../dynamics/simple-pendulum.toml" pendulum.png
expect 2 "would be overwritten" "bench onto its scene" "$program" bench pendulum.png --picture pendulum.png
mkdir shot
cp mine.toml shot/frame_00000.png
expect 2 "is the lesson that is drawn" "render onto its lesson" \
    "$program" render shot/frame_00000.png --out shot --frames 0
mkdir named
cp mine.toml named/manifest.json
expect 2 "manifest.json' is the lesson that is drawn" "render onto a lesson called manifest" \
    "$program" render named/manifest.json --out named --frames 0
cmp -s mine.toml mine.png && cmp -s mine.toml shot/frame_00000.png && cmp -s mine.toml named/manifest.json ||
    fail "a lesson was overwritten"
cp mine.toml grown.toml
timeout 100 "$program" solve grown.toml >>grown.toml 2>err && fail "results are written into the lesson"
cmp -s mine.toml grown.toml || fail "results behind '>>' changed the lesson"
grep -qF "expected another file after '>'" err || fail "results into the lesson are not named"

# ---- outputs that are not regular files
for output in pipe /dev/null /dev/full; do
    expect 2 "expected the name of a file" "a picture into $output" "$program" open mine.toml --picture $output
done
[ -c /dev/null ] && [ -c /dev/full ] || fail "a device was replaced"
mkdir folder.png
expect 2 "Is a directory" "a picture into a folder" "$program" open mine.toml --picture folder.png
expect 2 "No such file or directory" "a picture into no folder" "$program" plot mine.toml --out none/x.png
expect 2 "cannot be made a folder" "pictures into a file" "$program" render mine.toml --out mine.toml --frames 0
expect 2 "cannot be made a folder" "pictures into a loop of links" "$program" render mine.toml --out loop-a --frames 0
expect 2 "could not be written" "a table into a full disk" bash -c 'exec "$0" solve mine.toml >/dev/full' "$program"
expect 2 "could not be written" "a table into a closed stream" bash -c 'exec "$0" solve mine.toml >&-' "$program"

# ---- a limit of the size of files (4 blocks of 1024 bytes); SIGXFSZ would end the program
limited() { bash -c 'ulimit -f 4; exec "$@"' - "$@"; }
mkdir small
expect 2 "cannot write 'small/unfinished-frames/frame_00000.png': File too large" "pictures beyond the limit" \
    bash -c 'ulimit -f 4; exec "$@"' - "$program" render mine.toml --out small --frames 0:1
[ ! -e small/manifest.json ] || fail "there is a manifest without its pictures"
for output in small/x.png small/x.csv; do
    expect 2 "File too large" "a plot beyond the limit" \
        bash -c 'ulimit -f 4; exec "$@"' - "$program" plot mine.toml --out $output
    [ ! -e $output ] || fail "half a plot is there"
done
expect 2 "File too large" "the window's picture beyond the limit" \
    bash -c 'ulimit -f 4; exec "$@"' - "$program" open mine.toml --picture small/y.png
limited "$program" solve mine.toml >small/table.csv 2>err && fail "a table beyond the limit is status 0"
grep -qF "could not be written" err || fail "a table beyond the limit is not named"
no_draft . "a limit of the size of files"

# ---- killed in the middle: the pictures before are all there, no draft, and the next run clears up
"$program" render mine.toml --out killed --size 960x540 --frames 0 >out 2>err || fail "the run before the killed one"
cp -r killed before
"$program" render mine.toml --out killed --size 1000x560 >out 2>err &
pid=$!
for ((k = 0; k < 10000; ++k)); do
    [ ! -e killed/unfinished-frames/frame_00002.png ] || break
    sleep 0.01
done
kill -9 $pid
wait $pid 2>/dev/null
[ -e killed/unfinished-frames/frame_00002.png ] || fail "nothing was drawn in 100 s"
no_draft killed "a run that was killed"
diff -r -x unfinished-frames before killed >err || fail "a run that was killed changed the pictures before"
expect 0 "1 picture and manifest.json" "the run after a killed one" \
    "$program" render mine.toml --out killed --size 960x540 --frames 1
[ "$(ls killed | paste -sd ' ')" = "frame_00001.png manifest.json" ] || fail "left there: $(ls killed | paste -sd ' ')"

# ---- interrupted (Ctrl-C) in the middle: what was printed stays
got=0
# a shell lets its background processes ignore Ctrl-C
env --default-signal=INT "$program" try "$2/../benchmark/four-bar-16.toml" >out 2>err &
pid=$!
for ((k = 0; k < 10000; ++k)); do
    [ "$(wc -l <out)" -lt 3 ] || break
    sleep 0.01
done
kill -INT $pid
wait $pid || got=$?
[ "$got" -eq 130 ] || [ "$got" -eq 0 ] || fail "interrupted, try ends with status $got"
[ "$(wc -l <out)" -ge 3 ] || fail "interrupted, try has printed $(wc -l <out) lines"

# ---- fonts and lessons that are damaged
mkdir fonts
head -c 300000 /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf >fonts/DejaVuSans.ttf
export JOINTWISE_FONTS="$folder/fonts"
for command in "plot mine.toml --out p.png" "open mine.toml --picture p.png" "render mine.toml --out p --frames 0"; do
    # shellcheck disable=SC2086
    expect 2 "DejaVuSans.ttf' is damaged: it ends too early" "$command with half a font" "$program" $command
done
expect 2 "something needed is damaged" "doctor with half a font" "$program" doctor
unset JOINTWISE_FONTS
JOINTWISE_LESSONS="$folder/none" expect 2 "something needed is missing" "doctor without lessons" "$program" doctor

for pid in "${waiting[@]}"; do
    wait "$pid" || failures=$((failures + 1))
done

[ "$failures" -eq 0 ] || exit 1
echo "files test: passed"
