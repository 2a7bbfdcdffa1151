#!/bin/bash
# Counts instructions of texture lookups, of a picture of each scene, and of judging an upload (callgrind), and compares
# them with those in git. Unlike seconds they are the same on a busy machine.
#
#   ci/perf.sh [--renew]
#
#   --renew   writes the new counts to tests/perf/counts.txt, for a commit that says why
#
# Exit: 1 if one is more than 3 % above what it was.
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
counts=tests/perf/counts.txt
build=build/release/tests/perf
log=build/perf.log
renew=0
case ${1:-} in
    "") ;;
    --renew) renew=1 ;;
    *) sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" && exit 2 ;;
esac
mkdir -p -- build
{ ci/setup.sh && cmake --preset release && cmake --build --preset release --target perf_counts assets; } >"$log" 2>&1 || {
    tail -n 30 -- "$log"
    exit 3
}

folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
# The C library's functions that every x86-64 processor has: with others the counts would tell of the machine.
export GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX2,-AVX,-FMA,-FMA4,-SSE4_2,-SSE4_1,-SSSE3,-ERMS
count() {
    valgrind --tool=callgrind --toggle-collect=measured --callgrind-out-file="$folder/out" \
        "$build/perf_counts" "$1" >"$folder/log" 2>&1 || { cat -- "$folder/log" && exit 3; }
    awk '/^totals:/ { print $2 }' "$folder/out"
}

for name in $("$build/perf_counts" --list); do
    printf '%s %s\n' "$name" "$(count "$name")"
done >"$folder/counts"
result=0
awk '
    FILENAME == ARGV[1] { before[$1] = $2; next }
    {
        change = before[$1] ? 100 * ($2 / before[$1] - 1) : 0
        slower = change > 3
        printf "%-28s %14d %+7.2f %%%s\n", $1, $2, change, slower ? "  too many" : before[$1] ? "" : "  new"
        failed = failed || slower
    }
    END { exit failed }' "$counts" "$folder/counts" || result=1
if ((renew)); then
    cp -- "$folder/counts" "$counts"
    echo "written to $counts"
elif ((result)); then
    echo "more instructions than in $counts: make it fast again, or say in the commit why not and call ci/perf.sh --renew"
    exit 1
fi
