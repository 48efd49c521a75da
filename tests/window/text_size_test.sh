#!/usr/bin/env bash
# The real program in a real window: text that is made larger and smaller before everything that makes pictures again, and
# changes to the lesson when the window is closed or killed.
# Called by ctest: text_size_test.sh PROGRAM FOUR-BAR-LESSON. Needs Xvfb and xdotool.
set -euo pipefail

name="text size test"
program=$1
lesson=$2

. "$(dirname "${BASH_SOURCE[0]}")/window.sh"

# a picture that is saved has been drawn after all that was pressed before it
pictures=0
drawn() {
    local before
    before=$(find "$folder" -name 'mine-step-*.png' | wc -l)
    xdotool key p
    await 60 "a picture after: $1" bash -c "[ \$(find '$folder' -name 'mine-step-*.png' | wc -l) -gt $before ]"
    pictures=$((pictures + 1))
}

open_display
cp "$lesson" "$folder/mine.toml"

# every key that makes framebuffers or textures again, directly after another size of text
open_program "four-bar" --try "take out motor"
await 60 "the experiment" title_has "(changed)"
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

# killed: all changes to the lesson are kept all the same
copy="$folder/state/jointwise/unsaved/mine.toml"
await 60 "the copy of what was tried" test -s "$copy"
kill -9 "$pid"
wait "$pid" 2>/dev/null || true
pid=
"$program" check "$copy" >/dev/null 2>&1 || fail "the copy of what was tried is no lesson"
"$program" step "$copy" --until 0 >/dev/null || fail "the copy of what was tried cannot be told"

# closed: a message says where the copy is
open_program "four-bar" --try "take out motor"
await 60 "the experiment" title_has "(changed)"
close_program
[ "$status" -eq 0 ] || fail "the exit status is $status"
grep -q "what was tried and not saved is in '.*/unsaved/mine-2.toml'" "$folder/log" || fail "it is not said where it is"
echo "text size test: passed, $pictures pictures"
