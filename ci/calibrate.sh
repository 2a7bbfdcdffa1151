#!/bin/bash
# How sharp the grader is: grades the whole corpus, the correct files with g++ and clang++ at -O0, -O2, -O3 and
# -O3 -march=native with and without contraction, the wrong ones with both compilers. Prints false rejects, false
# accepts, points lost in functions that are not wrong, mistakes that are named right and wrong, and how close the
# closest file came on either side. Exit code 1 if anything is not as the files' first lines say. Takes about twenty
# minutes on two cores.
#
#   ci/calibrate.sh [--quick] [--jobs N]
#
#   --quick   only with the flags that uploads are compiled with
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
log=build/calibrate.log
mkdir -p -- build
{ ci/setup.sh && cmake --preset release && cmake --build --preset release --target calibrate; } >"$log" 2>&1 || {
    tail -n 30 -- "$log"
    exit 3
}
exec build/release/tests/grader/corpus/calibrate "$@"
