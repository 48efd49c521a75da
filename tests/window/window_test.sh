#!/usr/bin/env bash
# The real program in a real window: opened, stepped, pulled, reloaded, resized, closed.
# Called by ctest: window_test.sh PROGRAM FOUR-BAR-LESSON. Needs Xvfb, xauth and xdotool, no window manager.
set -euo pipefail

program=$1
lesson=$2

if [ "${JW_INSIDE_XVFB:-}" != yes ]; then
    # without a display it says what to do instead
    status=0
    message=$(env -u DISPLAY -u WAYLAND_DISPLAY "$program" open "$lesson" 2>&1) || status=$?
    [ "$status" -eq 2 ] || { echo "without a display the exit status is $status, not 2: $message"; exit 1; }
    for word in render step; do
        grep -q "$word" <<<"$message" || { echo "without a display '$word' is not named: $message"; exit 1; }
    done
    exec env -u WAYLAND_DISPLAY JW_INSIDE_XVFB=yes LIBGL_ALWAYS_SOFTWARE=1 timeout 120 \
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
    echo "window test: $1"
    echo "title: $(title)"
    cat "$folder/log"
    exit 1
}

# await SECONDS WHAT COMMAND...: until the command succeeds
await() {
    local end=$((SECONDS + $1)) what=$2
    shift 2
    until "$@" >/dev/null 2>&1; do
        kill -0 "$pid" 2>/dev/null || fail "the program ended before: $what"
        [ "$SECONDS" -lt "$end" ] || fail "waited in vain: $what"
        sleep 0.05
    done
}

find_window() { window=$(xdotool search --pid "$pid" --onlyvisible --name Jointwise | head -n 1) && [ -n "$window" ]; }
title() { xdotool getwindowname "${window:-0}" 2>/dev/null || true; }
title_has() { [[ "$(title)" == *"$1"* ]]; }
title_lacks() { [[ "$(title)" != *"$1"* ]]; }
has_size() { [ "$(xdotool getwindowgeometry --shell "$window" | sed -nE 's/^(WIDTH|HEIGHT)=//p' | paste -sd x)" = "$1" ]; }
# picture NAME WIDTHxHEIGHT: p saves the step that is shown under its number
picture() {
    local file="$folder/$1"
    xdotool key p
    await 20 "picture $1" test -s "$file"
    local size
    size=$(od -An -tu1 -j16 -N8 "$file" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }')
    [ "$size" = "$2" ] || fail "$1 has $size pixels, not $2"
    # a picture of one colour has two thousand bytes
    [ "$(stat -c %s "$file")" -gt 20000 ] || fail "$1 shows nothing"
}

cp "$lesson" "$folder/mine.toml"
(
    cd "$folder"
    exec env XDG_STATE_HOME="$folder/state" "$program" open mine.toml
) >"$folder/log" 2>&1 &
pid=$!
await 30 "the window" find_window
await 20 "the lesson's title" title_has "A four-bar of four revolutes"
xdotool windowfocus --sync "$window"

# step: every step is saved under its own number
xdotool key Right
picture mine-step-2.png 1280x720
xdotool key Right
picture mine-step-3.png 1280x720
cmp -s "$folder/mine-step-2.png" "$folder/mine-step-3.png" && fail "two steps look the same"

# pull: somewhere in the picture there is a body
xdotool key Home
for ((y = 180; y <= 460; y += 20)); do
    xdotool mousemove --window "$window" 330 "$y" mousedown 1
    xdotool mousemove --window "$window" 345 "$y" mousemove --window "$window" 370 "$y" mouseup 1
    picture "mine-step-1$( ((y > 180)) && echo "-$(((y - 160) / 20))" || true).png" 1280x720
    if title_has "(changed)"; then break; fi
done
await 5 "a body that can be pulled" title_has "(changed)"
xdotool key u
await 10 "undo" title_lacks "(changed)"

# the file is saved in an editor, with a mistake, and repaired
sed -i 's/^title = .*/title = "Saved anew"/' "$folder/mine.toml"
await 10 "the new title" title_has "Saved anew"
sed -i 's/^title = .*/title = 7/' "$folder/mine.toml"
sleep 0.7 # longer than the program looks away
title_has "Saved anew" || fail "the last good lesson does not stay"
sed -i 's/^title = .*/title = "Repaired"/' "$folder/mine.toml"
await 10 "the repaired title" title_has "Repaired"

xdotool windowsize "$window" 1000 640
await 10 "the new size" has_size 1000x640
xdotool key Right
picture mine-step-2-2.png 1000x640

xdotool key ctrl+o
await 10 "the list of lessons" title_lacks "Repaired"
xdotool key Escape
await 10 "the lesson again" title_has "Repaired"

xdotool key ctrl+q
for ((k = 0; k < 200; ++k)); do
    kill -0 "$pid" 2>/dev/null || break
    sleep 0.05
done
kill -0 "$pid" 2>/dev/null && fail "Ctrl+Q does not close it"
status=0
wait "$pid" || status=$?
pid=
[ "$status" -eq 0 ] || fail "the exit status is $status"
echo "window test: passed"
