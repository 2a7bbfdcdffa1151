#!/bin/bash
# Tries a command on a fresh Debian 12: a minimal system by debootstrap, a fresh clone of this repository inside.
#
#   ci/fresh.sh [--dirty] [--keep] [--user] [COMMAND...]      as root
#
#   COMMAND   runs in the clone (default: ./testat grade tests/submissions/example.cpp); its exit code is ours
#   --dirty   lays the working tree over the clone: uncommitted changes and new files come along
#   --keep    leaves the system's folder in place and prints where
#   --user    runs COMMAND as an ordinary user without sudo
#
# The new system has its own mounts and processes, and the host's root is not reachable from it. The minimal system and
# downloaded packages are kept in ${TMPDIR:-/tmp}/testat-fresh, so later runs start in seconds. Where packages come from
# is read from this machine's own apt configuration; a machine without Debian 12 sources uses debootstrap's default.
set -euo pipefail

suite=bookworm
root=$(dirname -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")")
cache=${TMPDIR:-/tmp}/testat-fresh
say() { printf 'fresh: %s\n' "$*" >&2; }
usage() { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; }

# "URI SUITE" of each Debian archive this machine uses for Debian 12, the main one first.
archives() {
    command -v apt-get >/dev/null || return 0
    # shellcheck disable=SC2016  # apt-get expands these, not the shell
    apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
        awk -v s="$suite" '$3 == "main" && ($2 == s || $2 == s "-updates" || $2 == s "-security") { print $1, $2 }' |
        sort -u | awk -v s="$suite" '{ if ($2 == s) print; else rest = rest $0 "\n" } END { printf "%s", rest }'
}

# The minimal system, made once. Renamed into place when whole, so that an interrupted run leaves nothing half done.
make_base() {
    local base=$1 mirror=$2
    say "making a minimal Debian 12 (once, about a minute)"
    rm -rf -- "$base.new"
    if ! debootstrap --variant=minbase "$suite" "$base.new" ${mirror:+"$mirror"} >"$base.log" 2>&1; then
        tail -n 20 -- "$base.log" >&2
        say "debootstrap failed; all of its output is in $base.log"
        return 1
    fi
    mv -- "$base.new" "$base"
}

# What a machine here needs to reach its archives: sources, apt's transport options, name lookup, certificates.
configure_system() {
    local system=$1 sources=$2
    if [[ -n $sources ]]; then
        rm -f -- "$system"/etc/apt/sources.list.d/*
        sed 's/^/deb /; s/$/ main/' <<<"$sources" >"$system/etc/apt/sources.list"
    fi
    apt-config dump Acquire | grep -E '^Acquire::(https?|Check-|Retries|Force)' >"$system/etc/apt/apt.conf.d/99host" || true
    cp -L -- /etc/resolv.conf "$system/etc/resolv.conf"
    if grep -q https: "$system/etc/apt/sources.list" && [[ -d /etc/ssl/certs ]]; then
        mkdir -p -- "$system/etc/ssl/certs"
        cp -L -- /etc/ssl/certs/ca-certificates.crt "$system/etc/ssl/certs/"
    fi
}

# A fresh clone, under a name with a space and an umlaut because people have those.
clone_into() {
    local target=$1 dirty=$2
    git -c safe.directory='*' clone --quiet --no-hardlinks -- "$root" "$target"
    if ((dirty)); then
        git -C "$root" -c safe.directory='*' ls-files --cached --others --exclude-standard -z |
            (cd "$root" && while IFS= read -r -d '' file; do [[ ! -e $file ]] || printf '%s\0' "$file"; done) |
            tar -C "$root" --null --files-from=- --create --file=- | tar -C "$target" --extract --file=-
    fi
}

# Inside the new mount and process namespaces: makes SYSTEM the root (pivot_root, because a mere chroot would forbid user
# namespaces and with them the cage), lets go of the host's root, runs the command.
enter() {
    local system=$1 user=$2 folder=$3
    shift 3
    mount --bind -- "$system" "$system"
    cd -- "$system"
    mount -t proc proc proc
    mount --rbind /dev dev
    mount -t tmpfs -o nosuid,nodev shm dev/shm
    pivot_root . .
    umount --lazy .
    cd -- "/$folder"
    local -a environment=(
        PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
        ${TERM:+TERM="$TERM"} ${CI:+CI="$CI"}
        ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} ${no_proxy:+no_proxy="$no_proxy"})
    if [[ -n $user ]]; then
        exec env -i "${environment[@]}" HOME="/home/$user" setpriv --reuid "$user" --regid "$user" --init-groups -- "$@"
    fi
    exec env -i "${environment[@]}" HOME=/root "$@"
}

if [[ ${1-} == --enter ]]; then
    shift
    enter "$@"
fi

dirty=0 keep=0 user=
while [[ ${1-} == -* ]]; do
    case $1 in
        --dirty) dirty=1 ;;
        --keep) keep=1 ;;
        --user) user=student ;;
        --help | -h) usage && exit 0 ;;
        *) say "unknown option $1" && exit 2 ;;
    esac
    shift
done
(($#)) || set -- ./testat grade tests/submissions/example.cpp
((EUID == 0)) || { say "needs root (debootstrap and mounts)" && exit 3; }
for tool in debootstrap unshare git; do
    command -v "$tool" >/dev/null || { say "needs $tool: apt-get install $tool" && exit 3; }
done

mkdir -p -- "$cache/archives"
sources=$(archives)
mirror=${sources%% *}
base=$cache/base-$suite
exec {lock}>"$cache/lock"
flock "$lock"
[[ -d $base ]] || make_base "$base" "$mirror" || exit 3
exec {lock}>&-

system=$(mktemp -d -- "$cache/system.XXXXXX")
chmod 755 -- "$system"
# shellcheck disable=SC2317  # the trap calls it
finish() {
    # Packages downloaded now are there for the next run (hard links: no bytes are copied).
    cp -aln -- "$system"/var/cache/apt/archives/*.deb "$cache/archives/" 2>/dev/null || true
    if ((keep)); then
        say "kept in $system"
    else
        rm -rf -- "$system"
    fi
}
trap finish EXIT
cp -a -- "$base/." "$system/"
cp -aln -- "$cache"/archives/*.deb "$system/var/cache/apt/archives/" 2>/dev/null || true
configure_system "$system" "$sources"

if [[ -n $user ]]; then
    chroot "$system" useradd --create-home "$user"
fi
folder="${user:+home/$user/}Übung testat"
clone_into "$system/$folder" "$dirty"
[[ -z $user ]] || chroot "$system" chown -R "$user:" "/$folder"

say "running in the fresh system: $*"
code=0
unshare --mount --pid --fork --kill-child --propagation private \
    -- bash "${BASH_SOURCE[0]}" --enter "$system" "$user" "$folder" "$@" || code=$?
exit "$code"
