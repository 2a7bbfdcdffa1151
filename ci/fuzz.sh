#!/bin/bash
# Feeds the readers of strangers' bytes (tests/fuzz) with random ones, under the address and undefined behaviour
# sanitizers, each for so many seconds.
#
#   ci/fuzz.sh [SECONDS]     default: 15
#
# Exit: 1 if one of them crashed; the input is in build/fuzz/found. Build the release preset first: one report of a
# real upload is among the seeds.
set -euo pipefail

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
seconds=${1:-15}
build=$PWD/build/fuzz
cmake --preset fuzz
cmake --build --preset fuzz --target fuzzers

rm -rf -- "$build/seeds"
mkdir -p -- "$build/found" "$build"/seeds/{answers,source,report,rubric,table,zip}
cp -- references/rubric.json "$build/seeds/rubric/"
cp -- references/exercise_03.cpp "$build/seeds/source/"
head -c 4096 /dev/zero >"$build/seeds/answers/zeros"
build/release/grader/testat grade tests/submissions/example.cpp --out "$build/example" >/dev/null
cp -- "$build/example/report.json" "$build/seeds/report/"

# A download as ILIAS makes it, with a sheet of one row; the sheet alone is a seed as well.
download=$build/download
sheet='<worksheet><sheetData><row><c t="inlineStr"><is><t>Name</t></is></c><c t="s"><v>0</v></c><c t="s"><v>1</v></c>'
sheet+='<c r="D1"><v>46350.5</v></c></row></sheetData></worksheet>'
rm -rf -- "$download"
mkdir -p -- "$download"/Sheet/Abgaben/{Name_Vorname_login_12,"Team 7/A_B_c_1"} "$download/xl/worksheets"
printf '%s' "$sheet" | tee "$build/seeds/table/sheet" >"$download/xl/worksheets/sheet1.xml"
printf '%s' '<sst><si><t>Vorname</t></si><si><t>login</t></si></sst>' >"$download/xl/sharedStrings.xml"
echo 'int x;' | tee "$download/Sheet/Abgaben/Name_Vorname_login_12/exercise_03 (2).cpp" \
    >"$download/Sheet/Abgaben/Team 7/A_B_c_1/Late - exercise_03.cpp"
(cd -- "$download" && cmake -E tar cf Sheet/Sheet.xlsx --format=zip xl &&
    cmake -E tar cf "$build/seeds/zip/download.zip" --format=zip Sheet)

for name in answers source report rubric table zip; do
    echo "$name"
    # Where the new inputs go comes first; the seeds are only read.
    mkdir -p -- "$build/corpus/$name"
    "$build/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -seed=1 -max_len=1048576 -timeout=20 -rss_limit_mb=4096 \
        -print_final_stats=1 -verbosity=0 -artifact_prefix="$build/found/$name-" "$build/corpus/$name" \
        "$build/seeds/$name" >"$build/$name.log" 2>&1 || { tail -n 40 -- "$build/$name.log" && exit 1; }
    grep number_of_executed_units "$build/$name.log"
done
