#!/bin/bash
# keys_test.sh PROGRAM: presses keys in the viewer's window, within with_display.sh, and writes the pictures that F4 saves
# into the current folder. Exit: the program's.
set -u

"$1" --width 40 --height 30 &
program=$!
window=$(timeout 30 xdotool search --sync --onlyvisible --name '^03_textures$')
xdotool windowfocus "$window"
press() {
    xdotool key "$1"
    sleep 0.3
}
wait_for() {
    for ((i = 0; i < 100; ++i)); do
        [[ -s $1 ]] && return
        sleep 0.1
    done
    echo "$1 was not written"
    kill "$program"
}

sleep 1
press F4
wait_for plane_nearest_recursive.png
press 3
press F4
wait_for plane_trilinear_recursive.png
press F4
wait_for plane_trilinear_recursive-2.png
# The left button drags the camera about, r brings it back.
# On a busy machine a hand that is too fast is not seen: it tries again, more slowly.
for pause in 0.2 0.5 1 2 4; do
    xdotool mousemove 800 400 sleep "$pause" mousedown 1 sleep "$pause" mousemove 900 450 sleep "$pause" mouseup 1
    sleep 1
    rm -f plane_trilinear_recursive-3.png
    press F4
    wait_for plane_trilinear_recursive-3.png
    cmp -s plane_trilinear_recursive.png plane_trilinear_recursive-3.png || break
done
press r
sleep 1
press F4
wait_for plane_trilinear_recursive-4.png
# An open combo keeps Escape for itself.
xdotool mousemove 100 20 click 1
sleep 0.5
press Escape
press F4
wait_for plane_trilinear_recursive-5.png
press Escape
wait "$program"
