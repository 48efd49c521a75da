#!/usr/bin/env bash
# The real program in a real window: opened, stepped, pulled, reloaded, resized, closed.
# Called by ctest: window_test.sh PROGRAM FOUR-BAR-LESSON. Needs Xvfb and xdotool.
set -euo pipefail

name="window test"
program=$1
lesson=$2

. "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# without a display the program says what to do instead
status=0
message=$(env -u DISPLAY "$program" open "$lesson" 2>&1) || status=$?
[ "$status" -eq 2 ] || fail "without a display the exit status is $status, not 2: $message"
for word in render step; do
    grep -q "$word" <<<"$message" || fail "without a display '$word' is not named: $message"
done

has_size() { [ "$(xdotool getwindowgeometry --shell "$window" | sed -nE 's/^(WIDTH|HEIGHT)=//p' | paste -sd x)" = "$1" ]; }
# picture NAME WIDTHxHEIGHT: the key p saves the step that is shown under its number
picture() {
    local file="$folder/$1"
    xdotool key p
    await 60 "picture $1" test -s "$file"
    local size
    size=$(od -An -tu1 -j16 -N8 "$file" | awk '{ print $3 * 256 + $4 "x" $7 * 256 + $8 }')
    [ "$size" = "$2" ] || fail "$1 has $size pixels, not $2"
    # a picture of one colour has two thousand bytes
    [ "$(stat -c %s "$file")" -gt 20000 ] || fail "$1 shows nothing"
}

open_display
cp "$lesson" "$folder/mine.toml"
open_program "A four-bar of four revolutes"

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
await 60 "a body that can be pulled" title_has "(changed)"
xdotool key u
await 60 "undo" title_lacks "(changed)"

# the file is saved in an editor, with a mistake, and repaired
sed -i 's/^title = .*/title = "Saved anew"/' "$folder/mine.toml"
await 60 "the new title" title_has "Saved anew"
sed -i 's/^title = .*/title = 7/' "$folder/mine.toml"
sleep 0.7 # longer than the program waits before it looks at the file again
title_has "Saved anew" || fail "the last good lesson does not stay"
sed -i 's/^title = .*/title = "Repaired"/' "$folder/mine.toml"
await 60 "the repaired title" title_has "Repaired"

xdotool windowsize "$window" 1000 640
await 60 "the new size" has_size 1000x640
xdotool key Right
picture mine-step-2-2.png 1000x640

xdotool key ctrl+o
await 60 "the list of lessons" title_lacks "Repaired"
xdotool key Escape
await 60 "the lesson again" title_has "Repaired"

close_program
[ "$status" -eq 0 ] || fail "the exit status is $status"
echo "window test: passed"
