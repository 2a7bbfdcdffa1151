#!/bin/bash
# Installs the Debian packages of ci/packages.txt that are not there yet. Does nothing, quickly, when all are.
#
#   ci/setup.sh [--grading] [--list | --missing]
#
#   --grading   only what building and running the grader needs, not what ci/check.sh needs on top
#   --list      prints the names of the packages
#   --missing   prints the names of those not installed
#
# Exit: 0 all there (now); 2 wrong usage; 3 could not install, with the command to run by hand on stderr.
set -euo pipefail

here=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
say() { printf 'setup: %s\n' "$*" >&2; }
usage() { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; }

# Names in the sections asked for, one a line; but for what another package has brought already, if that will do.
list() {
    awk -v only_grading="$grading" '
        /^\[/ { wanted = !only_grading || $1 == "[grading]"; next }
        wanted && $1 != "" && $1 !~ /^#/ { print $1, ($2 ~ /^unless=/ ? substr($2, 8) : "") }' "$here/packages.txt" |
        while read -r name program; do
            [[ -n $program ]] && command -v "$program" >/dev/null || printf '%s\n' "$name"
        done
}

# Names asked for and not installed. Where there is no dpkg we cannot know, so nothing is missing: the build will tell.
missing() {
    command -v dpkg-query >/dev/null || return 0
    local -a wanted
    mapfile -t wanted < <(list)
    # dpkg-query fails when it does not know a name, and prints the others all the same.
    { dpkg-query --show --showformat '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true; } |
        awk -v wanted="${wanted[*]}" '
            $2 == "installed" { installed[$1] = 1 }
            END { n = split(wanted, name, " "); for (i = 1; i <= n; i++) if (!installed[name[i]]) print name[i] }'
}

# A stranger's lock (a desktop's update service) is waited for; sudo forgets the environment, hence env behind it.
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=300 "$@" </dev/null >&2
}
install_packages() { apt update && apt install --yes --no-install-recommends "$@"; }

by_hand() {
    say "$1; as root, run:"
    say "  apt-get update && apt-get install --yes --no-install-recommends ${packages[*]}"
    exit 3
}

grading=0 action=install
for argument in "$@"; do
    case $argument in
        --grading) grading=1 ;;
        --list | --missing) action=${argument#--} ;;
        --help | -h) usage && exit 0 ;;
        *) say "unknown option $argument" && exit 2 ;;
    esac
done
case $action in
    list) list && exit 0 ;;
    missing) missing && exit 0 ;;
esac

mapfile -t packages < <(missing)
((${#packages[@]})) || exit 0
as_root=()
if ((EUID != 0)); then
    command -v sudo >/dev/null || by_hand "packages are missing, and this is neither root nor a machine with sudo"
    sudo true || by_hand "packages are missing, and sudo refused"
    as_root=(sudo)
fi
command -v apt-get >/dev/null || by_hand "packages are missing, and there is no apt-get here"

say "installing ${#packages[@]} Debian packages: ${packages[*]}"
if ! install_packages "${packages[@]}"; then
    say "that failed; trying once more"
    "${as_root[@]}" dpkg --configure -a >&2 || true # what an interrupted installation leaves behind
    install_packages "${packages[@]}" || by_hand "apt-get could not install everything"
fi
