#!/bin/bash
# What hostile uploads come to: grades every file of tests/attacks with and without its attack, and prints how it ended,
# the points, how much longer it took, and whether anything on this machine has changed. Exit code 1 if anything is not
# as the files' first lines say, if an attack gained or told something, or if the next upload is graded otherwise. Takes
# about ten minutes.
#
#   ci/attacks.sh [NAME...]
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
log=build/attacks.log
mkdir -p -- build
{ ci/setup.sh && cmake --preset release && cmake --build --preset release --target attack_table; } >"$log" 2>&1 || {
    tail -n 30 -- "$log"
    exit 3
}
exec build/release/tests/grader/attacks/attack_table "$@"
