#!/usr/bin/env bash
# The real program in a real window: an exercise that asks for a program, solved through the sandbox with the keyboard
# alone, and a window that is closed while a program runs.
# Called by ctest: exercise_test.sh PROGRAM EXERCISES-FOLDER. Needs Xvfb, xdotool and bubblewrap.
set -euo pipefail

name="exercise test"
program=$1
exercises=$2

. "$(dirname "${BASH_SOURCE[0]}")/window.sh"

bwrap --ro-bind / / --unshare-all true 2>/dev/null || { echo "$name: skipped, no sandbox can be made here"; exit 0; }
export XDG_DATA_HOME="$folder/data"
progress="$folder/data/jointwise/progress.toml"
answer="$folder/data/jointwise/exercises/rows-of-$$.py"

# a lesson with the exercise, under a name that no other process has
cat >"$folder/mine.toml" <<END
format = 1
title = "A program is asked for"
[[body]]
name = "arm"
[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]

END
awk -v folder="$exercises" -v own="rows-of-$$" '
    /^\[\[exercise\]\]/ { inside = 0; head = $0; next }
    /^name = "n1-row-code"/ { inside = 1; print head; print "name = \"" own "\""; next }
    inside && /^lesson = / { next }
    inside { sub(/^scene = "/, "scene = \"" folder "/"); print }' "$exercises/jacobians.toml" >>"$folder/mine.toml"

# Enter leads from the list into the exercise, into the field, and checks the answer there
enter_until() {
    xdotool key Return
    sleep 0.3
    "$@"
}
runs() { pgrep -f "/submission/rows-of-$$.py" >/dev/null; }

mkdir -p "$(dirname "$answer")"
cat >"$answer" <<'END'
import json, sys
def row(c):
    a = c["s_i_local"]
    b = [sum(c["A_i"][r][k] * c["s_j"][r] for r in range(3)) for k in range(3)]
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
print(json.dumps({"answers": [row(c) for c in json.load(sys.stdin)["cases"]]}))
END
open_display
open_program "A program is asked for"
xdotool key 6
await 60 "a right program is judged right" enter_until grep -qs "solved = 1" "$progress"

# closed while a program sleeps: the window closes at once, and the program ends with it
echo 'import time; time.sleep(1000)' >"$answer"
await 60 "the sleeping program runs" enter_until runs
close_program
[ "$status" -eq 0 ] || fail "the exit status is $status"
if runs; then fail "the program runs on after the window was closed"; fi
echo "$name: passed"
