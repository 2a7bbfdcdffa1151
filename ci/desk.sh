#!/bin/bash
# The tutor's desk at work: makes up an ILIAS download and grades it cold, again with nothing changed, killed again and
# again, and on a cluster of two nodes of which one dies. Prints every command, what it took, and whether all of them
# came to the same bytes, and checks what goes back to ILIAS. Exit code 1 if anything is not as it should be.
#
#   ci/desk.sh [--uploads N] [--kills N] [--jobs N] [--seed N] [--slurm]
#
#   --uploads N   in the download (300)
#   --kills N     so many times with SIGKILL, at random moments (20)
#   --jobs N      uploads at a time (one for each core)
#   --seed N      of the download and of the moments (a new one each time)
#   --slurm       also on two nodes (ci/slurm-up.sh), undisturbed, and with one that dies on the way
#
# Compared are all files that a batch writes, byte for byte, but for the times in them:
#   report.json    "ms" in run_time, and "..._ms" in timing
#   results.json   execution_time
#   summary.txt    the list of the slowest
set -euo pipefail

usage() { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; }

cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
uploads=300 kills=20 jobs=$(nproc) seed=$((RANDOM * 32768 + RANDOM)) slurm=0
while (($#)); do
    case $1 in
        --uploads | --kills | --jobs | --seed)
            [[ ${2-} =~ ^[0-9]{1,9}$ ]] || { echo "desk: $1 wants a number" >&2 && exit 2; }
            declare "${1#--}=$2"
            shift
            ;;
        --slurm) slurm=1 ;;
        --help | -h) usage && exit 0 ;;
        *) echo "desk: unknown option $1" >&2 && exit 2 ;;
    esac
    shift
done

root=$PWD log=build/desk.log
mkdir -p -- build
{ ci/setup.sh && cmake --preset release && cmake --build --preset release --target grading make_export check_feedback; } \
    >"$log" 2>&1 || {
    tail -n 30 -- "$log"
    exit 3
}
PATH=$root/build/release/grader:$root/build/release/tests/grader/desk:$PATH

# family PID: all that come from a process, with their resident memory in KB.
family() {
    { cat /proc/[0-9]*/status 2>/dev/null || true; } | awk -v root="$1" '
        $1 == "Pid:" { pid = $2; kb[pid] = 0 }
        $1 == "PPid:" { parent[pid] = $2 }
        $1 == "VmRSS:" { kb[pid] = $2 }
        END {
            for (pid in kb) {
                for (at = parent[pid]; at > 1 && at != root;) at = parent[at]
                if (at == root) print pid, kb[pid]
            }
        }'
}

place=$(mktemp -d)
# shellcheck disable=SC2317  # the trap calls it
clean_up() {
    local pid
    for pid in $(family $$ | cut -d ' ' -f 1); do
        kill -KILL "$pid" 2>/dev/null || true
    done
    [[ ! -d $place/slurm ]] || "$root/ci/slurm-up.sh" --down "$place/slurm" || true
    rm -rf -- "$place"
}
trap clean_up EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
cd -- "$place"
mkdir temporary
export TMPDIR=$place/temporary # what is killed leaves its temporary files behind

failed=0
complain() {
    printf 'WRONG: %s\n' "$*"
    failed=1
}
show() { printf '\n$ %s\n' "$*"; }
seconds() { printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)); }
now_ms() { echo $((${EPOCHREALTIME/[^0-9]/} / 1000)); }
quotient() { awk -v a="$1" -v b="$2" -v digits="$3" 'BEGIN { printf "%.*f", digits, a / b }'; }
random_ms() { echo $(((RANDOM * 32768 + RANDOM) % $1 + 1)); }

# resident PID: memory of all that come from it, in MB; pages that are shared count for each.
resident() { family "$1" | awk '{ sum += $2 } END { print int(sum / 1024) }'; }

# measured COMMAND...: sets wall (ms), cpu (s) and peak (MB). What it prints goes to last.log.
measured() {
    local pid used user system code=0
    show "$@"
    (
        TIMEFORMAT='%R %U %S'
        { time "$@" >last.log 2>&1; } 2>last.time
    ) &
    pid=$!
    peak=0
    while kill -0 $pid 2>/dev/null; do
        used=$(resident $pid)
        ((used <= peak)) || peak=$used
        sleep 0.3
    done
    wait $pid || code=$?
    read -r wall user system <last.time
    wall=$(quotient "$wall" 0.001 0)
    cpu=$(awk -v a="$user" -v b="$system" 'BEGIN { print a + b }')
    if ((code)); then
        complain "exit code $code"
        tail -n 5 last.log
    fi
}

# grade FOLDER: a batch into it, in a process group of its own, in the background; sets `batch`.
grade() {
    local -a command=(testat batch download.zip --out "$1" --jobs "$jobs" --assignment 77 --lang en "${@:2}")
    setsid "${command[@]}" >last.log 2>&1 &
    batch=$!
}

without_times() {
    case $1 in
        */report.json)
            sed -e '/^  "run_time": \[$/,/^  \]/{/^      "ms": /d}' -e '/^  "timing": {$/,/^  }/{/^    "[a-z]*_ms": /d}' "$1"
            ;;
        */results.json) sed -e '/^  "execution_time": /d' "$1" ;;
        */summary.txt) sed -e '/^Slowest (s)$/,/^$/d' "$1" ;;
    esac
}

# What is in each file of a batch's folder, times aside. The lock is empty, and work/ is what was under way.
listing() (
    timed=('(' -name report.json -o -name results.json -o -path ./summary.txt ')')
    cd -- "$1"
    {
        find . -type f ! -path './.testat/work/*' ! "${timed[@]}" -print0 | xargs -0 sha256sum
        find . -type f ! -path './.testat/work/*' "${timed[@]}" -print0 | while IFS= read -r -d '' file; do
            printf '%s  %s\n' "$(without_times "$file" | sha256sum | cut -d ' ' -f 1)" "$file"
        done
    } | LC_ALL=C sort -k 2
)

# compare FOLDER: with that of the undisturbed run.
compare() {
    listing local >local.list
    listing "$1" >other.list
    if diff local.list other.list >difference; then
        echo "the same bytes: $(wc -l <other.list) files"
    else
        complain "$1 is not what local is"
        head -n 20 difference
    fi
}

# Results are folders that are never written into again.
results() { find "$1/.testat/results" -mindepth 1 -maxdepth 1 -printf '%f %i %T@\n' 2>/dev/null | LC_ALL=C sort; }

# kill_at_random FOLDER: batches into it that are killed. Where one is done first, the next is killed sooner.
kill_at_random() {
    local landed=0 code delay
    local -i span=$((2 * cold / kills + 1))
    local -a moments=()
    show "testat batch download.zip --out $1 ... (killed $kills times with SIGKILL at random moments, seed $seed)"
    while ((landed < kills)); do
        grade "$1"
        delay=$(random_ms $span) code=0
        sleep "$(seconds "$delay")"
        kill -KILL -- "-$batch" 2>/dev/null || kill -KILL "$batch" 2>/dev/null || true
        wait "$batch" 2>/dev/null || code=$?
        batch=
        if ((code == 137)); then
            results "$1" >"kept.$landed"
            landed=$((landed + 1))
            moments+=("$(seconds "$delay")")
        elif ((code == 0)); then
            span=$((unchanged > 1 ? unchanged : 2))
        else
            complain "exit code $code after a kill"
            tail -n 5 last.log
            return
        fi
    done
    echo "killed after ${moments[*]} s"
    measured testat batch download.zip --out "$1" --jobs "$jobs" --assignment 77 --lang en
    results "$1" >kept.last
    for file in kept.*; do
        [[ -z $(LC_ALL=C comm -23 "$file" kept.last) ]] || complain "something was graded twice: $file"
    done
}

# Processes of the cluster's tasks on a node.
on_node() {
    local file
    { grep -lzxF "SLURMD_NODENAME=$1" /proc/[0-9]*/environ 2>/dev/null || true; } | while IFS= read -r file; do
        if grep -qzxF "SLURM_CONF=$SLURM_CONF" "$file" 2>/dev/null; then
            file=${file#/proc/}
            echo "${file%/environ}"
        fi
    done
}

# end_node NAME: as if its power had failed.
end_node() {
    local -a pids
    mapfile -t pids < <(on_node "$1")
    kill -KILL "$(cat -- "slurm/slurmd.$1.pid")"
    kill -KILL "${pids[@]}" 2>/dev/null || true
}

# wait_for_node NAME: a task runs there, or the batch is done.
wait_for_node() {
    while [[ -z $(on_node "$1") ]] && kill -0 "$batch" 2>/dev/null; do
        sleep 0.2
    done
}

# A batch on the cluster, of which a node dies while it grades.
lose_a_node() {
    local begin delay code=0
    show "testat batch download.zip --out one-node --executor slurm --jobs 2 --assignment 77 --lang en (n2 dies)"
    begin=$(now_ms)
    jobs=2 grade one-node --executor slurm
    wait_for_node n2
    delay=$(random_ms $((cold / 4 + 1)))
    sleep "$(seconds "$delay")"
    wait_for_node n2 # it may be between two tasks
    end_node n2
    echo "n2 died $(seconds $(($(now_ms) - begin))) s after the start"
    wait "$batch" || code=$?
    batch=
    echo "done after $(seconds $(($(now_ms) - begin))) s"
    ((code == 0)) || complain "exit code $code"
    grep ' were lost' last.log || complain "no task was lost"
    compare one-node
}

on_slurm() {
    local environment
    environment=$("$root/ci/slurm-up.sh" "$place/slurm")
    eval "$environment"
    measured testat batch download.zip --out cluster --executor slurm --jobs 2 --assignment 77 --lang en
    echo "slurm, two nodes of one CPU: $(seconds "$wall") s, local with $jobs jobs $(seconds "$cold") s:" \
        "$(quotient $((100 * cold)) "$wall" 0) % of its rate"
    compare cluster
    lose_a_node
}

RANDOM=$((seed % 32768))
show make_export download.zip --uploads "$uploads" --seed "$seed"
make_export download.zip --uploads "$uploads" --seed "$seed"

measured testat batch download.zip --out local --jobs "$jobs" --assignment 77 --lang en
cold=$wall
graded=$(results local | wc -l)
printf 'cold: %s s, %s uploads a minute; CPU: %s s an upload, %s s a file that is graded (%d of %d); memory: %d MB at most\n' \
    "$(seconds "$cold")" "$(quotient $((60000 * uploads)) "$cold" 1)" "$(quotient "$cpu" "$uploads" 2)" \
    "$(quotient "$cpu" "$graded" 2)" "$graded" "$uploads" "$peak"

listing local >before.list
measured testat batch download.zip --out local --jobs "$jobs" --assignment 77 --lang en
unchanged=$wall
echo "nothing changed: $(seconds "$unchanged") s"
listing local >after.list
cmp before.list after.list || complain "the second run has changed something"

if ((kills)); then
    kill_at_random killed
    compare killed
fi
((!slurm)) || on_slurm

show check_feedback download.zip local --assignment 77
check_feedback download.zip local --assignment 77 || complain "ILIAS would not take it"

printf '\n%s\n' "$( ((failed)) && echo "something is wrong" || echo "all as it should be")"
exit $failed
