#!/bin/bash
# Makes pages and looks at them in Chromium.
#
#   tests/browser/run.sh FOLDER MAKE_PAGES
#
#   FOLDER       of packages, pages and screenshots; the packages are installed when the lock file has changed
#   MAKE_PAGES   the program that makes the pages
#
# CHROMIUM names another browser than /usr/bin/chromium.
set -euo pipefail

sources=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
folder=$1 make_pages=$2
mkdir -p -- "$folder"
if ! cmp -s -- "$sources/package-lock.json" "$folder/package-lock.json"; then
    cp -- "$sources/package.json" "$folder/"
    cp -- "$sources/package-lock.json" "$folder/new-lock.json"
    mv -- "$folder/new-lock.json" "$folder/package-lock.json"
    (cd -- "$folder" && npm ci --no-audit --no-fund --ignore-scripts) || {
        rm -f -- "$folder/package-lock.json"
        exit 1
    }
fi
rm -rf -- "$folder/pages"
mkdir -- "$folder/pages"
"$make_pages" "$folder/pages" >"$folder/pages/times.json"
TESTAT_BROWSER_FOLDER=$folder exec node --test --test-reporter=spec "$sources"
