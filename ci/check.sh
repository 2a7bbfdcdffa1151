#!/bin/bash
# Everything CI runs, in order, the same on a developer's machine: stops at the first step that fails.
#
#   ci/check.sh [--quick | --thorough]
#
#   --quick      leaves out the sanitizers, fuzzing and clang-tidy
#   --thorough   clang-tidy reads all files, not only those that the last twenty commits have changed
#
# The last line is "N passed, N failed": the tests ctest ran, over all presets; a step that fails without a failing test
# counts as one. Logs and test results are in build/check.
set -euo pipefail
exec </dev/null

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
root=$PWD
results=$root/build/check
jobs=$(nproc)
usage() { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' ci/check.sh; }

# step TITLE COMMAND...: runs COMMAND with set -e in force in a process of its own.
step() {
    local title=$1 begin=$SECONDS code
    shift
    printf '\n== %s (at %d s)\n' "$title" "$SECONDS"
    set +e
    (
        set -e
        "$@"
    )
    code=$?
    set -e
    if ((code)); then
        printf '\nFAILED: %s, after %d s, exit code %d\n' "$title" $((SECONDS - begin)) "$code"
        exit 1
    fi
    printf '== %s: ok, %d s\n' "$title" $((SECONDS - begin))
}

# The sum of ATTRIBUTE over ctest's results.
count() {
    cat -- "$results"/*.xml 2>/dev/null | tr '\n\t' '  ' | grep -o '<testsuite [^>]*>' |
        sed -n "s/.* $1=\"\([0-9]*\)\".*/\1/p" | awk '{ sum += $1 } END { print sum + 0 }'
}

# shellcheck disable=SC2317  # the trap calls it
print_totals() {
    local code=$? failed passed
    failed=$(count failures || true)
    passed=$(($(count tests || true) - failed - $(count skipped || true) - $(count disabled || true)))
    ((code == 0 || failed)) || failed=1
    printf '\n%d passed, %d failed\n' "$passed" "$failed"
}

# Runs a command that says much, and shows it only if it fails.
quietly() {
    local log=$results/$1.log
    shift
    "$@" >"$log" 2>&1 || {
        local code=$?
        tail -n 60 -- "$log"
        printf 'all of it: %s\n' "$log"
        return "$code"
    }
}

# The project's own files that match, NUL-separated, new ones included. A container's root may not own the clone.
files() {
    git -c safe.directory="$root" ls-files -z --cached --others --exclude-standard -- "$@" |
        while IFS= read -r -d '' file; do [[ ! -f $file ]] || printf '%s\0' "$file"; done
}

# What submissions look like is their authors' business.
format() {
    files '*.h' '*.cpp' ':!tests/submissions' ':!tests/attacks' |
        xargs -0 -r -n 20 -P "$jobs" clang-format --dry-run -Werror
}

scripts() { files testat .ci/run '*.sh' | xargs -0 -r shellcheck; }

# build PRESET [what else cmake --build takes]; tests PRESET [what else ctest takes]
# Warnings are errors where no sanitizer confuses the compiler about the libraries' headers.
build() {
    cmake --preset "$1" -DTESTAT_WERROR="$([[ $1 == *san ]] && echo OFF || echo ON)"
    with_steady_addresses "$1" cmake --build --preset "$1" "${@:2}"
}
# One test more than there are processors: some of them wait most of their time.
tests() {
    with_steady_addresses "$1" ctest --preset "$1" -j $((jobs + 1)) --output-junit "$results/$1.xml" "${@:2}"
}

# GCC 12's sanitizers lose their way in the larger random offsets of newer kernels. Some containers do not let one turn
# those off; there we try as it is.
with_steady_addresses() {
    local -a steady=(setarch "$(uname -m)" --addr-no-randomize)
    if [[ $1 != *san ]] || ! "${steady[@]}" true 2>/dev/null; then
        steady=()
    fi
    "${steady[@]}" "${@:2}"
}

address_sanitizer() {
    build asan
    tests asan --label-exclude release-only --no-tests=error
}

# The cage of somebody who is not root is another one: with a user namespace. So are a few attacks from within.
as_another_user() {
    local folder user=65534
    folder=$(mktemp -d)
    # shellcheck disable=SC2064  # now, while the name is known
    trap "rm -rf -- '$folder'" EXIT
    chown "$user:$user" "$folder"
    local -a become=(setpriv "--reuid=$user" "--regid=$user" --clear-groups env "HOME=$folder" "TMPDIR=$folder")
    local -a attacks=(opens_the_solution kills_its_parents starts_processes_without_end becomes_root makes_namespaces
        embeds_the_environment takes_all_memory leaves_a_note_behind_the_answers)
    "${become[@]}" build/release/grader/testat doctor
    quietly another-user "${become[@]}" build/release/tests/grader/grader_tests \
        --gtest_filter='Cage*:Cage/*:*Restrict*' --gtest_output="xml:$folder/another-user.xml"
    cp -- "$folder/another-user.xml" "$results/"
    "${become[@]}" build/release/grader/testat grade references/exercise_03.cpp --out "$folder/report" |
        grep -F ': 20.00 of 20.00'
    "${become[@]}" build/release/tests/grader/attacks/attack_table "${attacks[@]}"
}

fuzz() { with_steady_addresses asan ci/fuzz.sh 8; }

# The target thread_tests builds the tests labelled `threads`; nothing else has to be built for them.
thread_sanitizer() {
    build tsan --target thread_tests
    tests tsan --label-regex '^threads$' --no-tests=error
}

# Sources that the last twenty commits have changed; all where git does not go back so far.
recent_sources() {
    if ((!thorough)) && git -c safe.directory="$root" rev-parse --quiet --verify HEAD~20 >/dev/null; then
        git -c safe.directory="$root" diff --name-only --diff-filter=d HEAD~20 -- 'framework/*.cpp' 'grader/*.cpp'
    else
        files 'framework/*.cpp' 'grader/*.cpp' | tr '\0' '\n'
    fi
}

# Clang cannot read GCC's precompiled headers, so tidy sees the release build's commands without them.
tidy() {
    local -a patterns
    mkdir -p -- "$results/tidy"
    sed -E "s# -include ('[^']*/cmake_pch\.hxx'|\\\\\"[^\"]*/cmake_pch\.hxx\\\\\"|[^ ]*/cmake_pch\.hxx)##; s# -Winvalid-pch##" \
        build/release/compile_commands.json >"$results/tidy/compile_commands.json"
    mapfile -t patterns < <(recent_sources | while IFS= read -r file; do
        # shellcheck disable=SC2001,SC2016  # a regular expression, in which the shell has no part
        printf '^%s$\n' "$(sed 's/[][\.*^$(){}?+|]/\\&/g' <<<"$root/$file")"
    done)
    echo "${#patterns[@]} files"
    ((${#patterns[@]} == 0)) || quietly tidy run-clang-tidy -p "$results/tidy" -j "$jobs" -quiet \
        -extra-arg=-Wno-unknown-warning-option "${patterns[@]}"
}

# What students get, built the way the sheet says, in a folder named the way students name folders: as it is handed out,
# and with the solution in it. The template makes no mip levels beyond the first.
renderings=19 mip_levels=8
template() {
    local folder
    folder=$(mktemp -d)
    # shellcheck disable=SC2064  # now, while the name is known
    trap "rm -rf -- '$folder'" EXIT
    mkdir -- "$folder/Übung 3"
    cp -r submission_template framework "$folder/Übung 3/"
    cd -- "$folder/Übung 3/submission_template"
    mkdir build
    cd build
    quietly template-cmake cmake ../
    quietly template-make make -j "$jobs"
    create_images $((renderings + 1))
    cp -- "$root/references/exercise_03.cpp" ..
    quietly solution-make make
    create_images $((renderings + mip_levels))
    quietly debug-cmake cmake -DCMAKE_BUILD_TYPE=Debug -DTESTAT_SANITIZE=address,undefined ../
    quietly debug-make make -j "$jobs"
    with_steady_addresses asan ./03_textures --scene plane --width 32 --height 32 --output small.png
}

# The program in this folder writes as many whole pictures as EXPECTED.
create_images() {
    local expected=$1 written
    rm -rf assignment_images
    ./03_textures --create_images
    written=$(find assignment_images -type f -name '*.png' -size +0 | wc -l)
    echo "$written pictures of $expected"
    ((written == expected))
}

quick=0 thorough=0
for argument in "$@"; do
    case $argument in
        --quick) quick=1 ;;
        --thorough) thorough=1 ;;
        --help | -h) usage && exit 0 ;;
        *) echo "check: unknown option $argument" >&2 && exit 2 ;;
    esac
done

mkdir -p -- "$results"
rm -f -- "$results"/*.xml
trap print_totals EXIT
SECONDS=0
step "packages" quietly setup ci/setup.sh
step "format" quietly format format
step "shell scripts" scripts
step "build" build release
step "tests" tests release --no-tests=error
((EUID)) || step "as another user than root" as_another_user
step "the template's own build" template
if ((!quick)); then
    step "address and undefined behaviour sanitizers" address_sanitizer
    step "thread sanitizer" thread_sanitizer
    step "fuzzing" fuzz
    step "clang-tidy" tidy
fi
