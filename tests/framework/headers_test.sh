#!/bin/bash
# headers_test.sh INCLUDE_DIR: every header of cglib compiles without a warning, all of them together with each
# compiler and standard, and each on its own with one.
set -u -o pipefail
include=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

headers=$(cd "$include" && ls cglib/*/*.h)
for header in $headers; do
    echo "#include <$header>" | tee -a "$work/all.cpp" > "$work/$(basename "$header" .h).cpp"
done

check() { # COMPILER STANDARD FILE
    "$1" -std="$2" -Wall -Wextra -Wpedantic -Wshadow -Werror -DGLM_ENABLE_EXPERIMENTAL -D_USE_MATH_DEFINES \
        -I"$include" -fsyntax-only "$3" || { echo "FAILED: $1 $2 $(cat "$3")"; return 1; }
}
export -f check
export include

{
    for compiler in g++ clang++; do
        for standard in c++11 c++14 c++17 c++20; do
            echo "$compiler $standard $work/all.cpp"
        done
    done
    for header in $headers; do
        echo "g++ c++11 $work/$(basename "$header" .h).cpp"
    done
} | xargs -P "$(nproc)" -L 1 bash -c 'check "$@"' check
