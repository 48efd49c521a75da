# shellcheck shell=bash
# Parts that the tests of the real window share: a display of their own, the program in it, and waiting. Sourced after
# 'name', 'program' and 'lesson' are set; needs Xvfb and xdotool, no window manager.

# ends before ctest would kill it, and cleans up then
if [ -z "${JW_LIMITED:-}" ]; then JW_LIMITED=yes exec timeout 280 "$0" "$@"; fi
unset WAYLAND_DISPLAY
export LIBGL_ALWAYS_SOFTWARE=1
folder=$(mktemp -d)
pid=
display_pid=
finish() {
    if [ -n "$pid" ]; then kill "$pid" 2>/dev/null || true; fi
    if [ -n "$display_pid" ]; then kill "$display_pid" 2>/dev/null || true; fi
    rm -rf "$folder"
}
trap finish EXIT

title() { xdotool getwindowname "${window:-0}" 2>/dev/null || true; }
title_has() { [[ "$(title)" == *"$1"* ]]; }
title_lacks() { [[ "$(title)" != *"$1"* ]]; }
find_window() { window=$(xdotool search --pid "$pid" --onlyvisible --name Jointwise | head -n 1) && [ -n "$window" ]; }

fail() {
    echo "$name: $1"
    echo "title: $(title)"
    cat "$folder/log" 2>/dev/null || true
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

# Without -noreset the server starts again whenever its last client leaves, and refuses whoever connects meanwhile:
# xdotool comes and goes all the time. The server itself takes a number that nobody else has.
open_display() {
    local ready number
    exec {ready}< <(exec Xvfb -displayfd 1 -noreset -nolisten tcp -screen 0 1600x1000x24 2>"$folder/xvfb.log")
    display_pid=$!
    read -r -t 60 number <&"$ready" || { cat "$folder/xvfb.log"; fail "Xvfb gives no display"; }
    export DISPLAY=:$number
}

# open_program TITLE ARGUMENTS...: the lesson as mine.toml, whose title has these words
open_program() {
    local words=$1
    shift
    (
        cd "$folder"
        exec env XDG_STATE_HOME="$folder/state" "$program" open mine.toml "$@"
    ) >"$folder/log" 2>&1 &
    pid=$!
    await 60 "the window" find_window
    await 60 "the lesson's title" title_has "$words"
    xdotool windowfocus --sync "$window"
}

# close_program: closes it by its key, within ten seconds; its exit status is 'status'
close_program() {
    xdotool key ctrl+q
    for ((k = 0; k < 200; ++k)); do
        kill -0 "$pid" 2>/dev/null || break
        sleep 0.05
    done
    kill -0 "$pid" 2>/dev/null && fail "Ctrl+Q does not close it"
    status=0
    wait "$pid" || status=$?
    pid=
}
