#!/usr/bin/env bash
# The real program in a real window: text that is made larger and smaller before whatever makes pictures anew, and
# what was tried when the window is closed or killed.
# Called by ctest: text_size_test.sh PROGRAM FOUR-BAR-LESSON. Needs Xvfb, xauth and xdotool, no window manager.
set -euo pipefail

program=$1
lesson=$2

if [ "${JW_INSIDE_XVFB:-}" != yes ]; then
    exec env -u WAYLAND_DISPLAY JW_INSIDE_XVFB=yes LIBGL_ALWAYS_SOFTWARE=1 timeout 280 \
        xvfb-run -a -s "-screen 0 1600x1000x24" "$0" "$@"
fi

folder=$(mktemp -d)
pid=
finish() {
    if [ -n "$pid" ]; then kill "$pid" 2>/dev/null || true; fi
    rm -rf "$folder"
}
trap finish EXIT

fail() {
    echo "text size test: $1"
    cat "$folder/log"
    exit 1
}

# await WHAT COMMAND...: until the command succeeds
await() {
    local end=$((SECONDS + 60)) what=$1
    shift
    until "$@" >/dev/null 2>&1; do
        kill -0 "$pid" 2>/dev/null || fail "the program ended before: $what"
        [ "$SECONDS" -lt "$end" ] || fail "waited in vain: $what"
        sleep 0.05
    done
}

find_window() { window=$(xdotool search --pid "$pid" --onlyvisible --name Jointwise | head -n 1) && [ -n "$window" ]; }
title_has() { [[ "$(xdotool getwindowname "$window" 2>/dev/null || true)" == *"$1"* ]]; }

# begin ARGUMENTS...
begin() {
    (
        cd "$folder"
        exec env XDG_STATE_HOME="$folder/state" "$program" open mine.toml "$@"
    ) >"$folder/log" 2>&1 &
    pid=$!
    await "the window" find_window
    await "the lesson's title" title_has "four-bar"
    xdotool windowfocus --sync "$window"
}

# a picture that is saved has been drawn after all that was pressed before it
pictures=0
drawn() {
    local before
    before=$(find "$folder" -name 'mine-step-*.png' | wc -l)
    xdotool key p
    await "a picture after: $1" bash -c "[ \$(find '$folder' -name 'mine-step-*.png' | wc -l) -gt $before ]"
    pictures=$((pictures + 1))
}

cp "$lesson" "$folder/mine.toml"

# every key that makes framebuffers or textures anew, right behind another size of text
begin --try "take out motor"
await "the experiment" title_has "(changed)"
for sequence in "plus space" "minus space" "plus resize:1100x700" "minus resize:900x640" "plus g Escape" \
    "minus minus g Escape" "plus plus d space" "minus m" "plus resize:1280x720 space g Escape space"; do
    for key in $sequence; do
        case $key in
            resize:*) xdotool windowsize "$window" "$(sed 's/resize:\(.*\)x.*/\1/' <<<"$key")" "${key##*x}" ;;
            *) xdotool key --clearmodifiers "$key" ;;
        esac
    done
    kill -0 "$pid" 2>/dev/null || fail "the program ended after: $sequence"
    drawn "$sequence"
done
[ ! -s "$folder/log" ] || fail "something was complained about"

# killed: what was tried is there all the same
copy="$folder/state/jointwise/unsaved/mine.toml"
await "the copy of what was tried" test -s "$copy"
kill -9 "$pid"
wait "$pid" 2>/dev/null || true
pid=
"$program" check "$copy" >/dev/null 2>&1 || fail "the copy of what was tried is no lesson"
"$program" step "$copy" --until 0 >/dev/null || fail "the copy of what was tried cannot be told"

# closed: it is said where it is
begin --try "take out motor"
await "the experiment" title_has "(changed)"
xdotool key ctrl+q
for ((k = 0; k < 600; ++k)); do
    kill -0 "$pid" 2>/dev/null || break
    sleep 0.05
done
status=0
wait "$pid" || status=$?
pid=
[ "$status" -eq 0 ] || fail "the exit status is $status"
grep -q "what was tried and not saved is in '.*/unsaved/mine-2.toml'" "$folder/log" || fail "it is not said where it is"
echo "text size test: passed, $pictures pictures"
