#!/bin/bash
# with_display.sh COMMAND...: runs a command with an X display of its own, 1280 x 800, that nobody sees. OpenGL is Mesa's
# software renderer. Exit: the command's, 124 if it took two minutes, or 3 if there is no display.
set -u

coproc display { exec Xvfb -displayfd 1 -screen 0 1280x800x24 -nolisten tcp 2>/dev/null; }
# shellcheck disable=SC2154  # coproc sets it
server=$display_PID
if ! read -r -t 20 number <&"${display[0]}"; then
    echo "Xvfb did not start" >&2
    exit 3
fi
# What Mesa still holds at exit is no leak of ours.
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0
DISPLAY=:$number LIBGL_ALWAYS_SOFTWARE=1 timeout 120 "$@"
code=$?
kill "$server"
wait "$server" 2>/dev/null
exit "$code"
