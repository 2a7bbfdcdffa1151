#!/bin/bash
# What the cage costs: grades the solution with and without it, in turn, and compares the least CPU time of each.
#
#   ci/cage_cost.sh [RUNS]     default: 9
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
runs=${1:-9}
./testat --version
out=$(mktemp -d)
trap 'rm -rf -- "$out"' EXIT

# Seconds of CPU time, of all processes.
cpu_time() {
    local TIMEFORMAT='%U %S'
    { time build/release/grader/testat grade references/exercise_03.cpp --out "$out" "$@" >/dev/null; } 2>&1 |
        awk '{ print $1 + $2 }'
}

for ((i = 0; i < runs; i++)); do
    printf '%s %s\n' "$(cpu_time)" "$(cpu_time --no-sandbox)"
done | awk '
    { printf "caged %.2f s, without %.2f s\n", $1, $2 }
    NR == 1 || $1 < caged { caged = $1 }
    NR == 1 || $2 < bare { bare = $2 }
    END { printf "least CPU time: caged %.2f s, without %.2f s: %+.1f %%\n", caged, bare, 100 * (caged / bare - 1) }'
