#!/bin/bash
# Starts a Slurm cluster of two nodes, n1 and n2, with one CPU each on this machine, to try and to test
# `testat batch --executor slurm`. Where it runs already, only what is missing is started.
#
#   eval "$(ci/slurm-up.sh [STATE])"   prints "export SLURM_CONF=..." once both nodes are idle
#   ci/slurm-up.sh --down [STATE]      ends all of it, and the tasks that run
#
#   STATE   the folder of everything that Slurm writes; by default testat-slurm-<uid> among the temporary files
#
# Exit: 0 it runs (--down: it is gone); 2 wrong usage; 3 it does not, with the reason on stderr.
set -euo pipefail
PATH=$PATH:/usr/sbin:/sbin

say() { printf 'slurm-up: %s\n' "$*" >&2; }
usage() { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; }
fail() {
    say "$1"
    tail -n 5 -- "$state"/*.log >&2 2>/dev/null || true
    exit 3
}

# is_free PORT: nobody listens there.
is_free() { ! (exec 3<>"/dev/tcp/127.0.0.1/$1") 2>/dev/null; }

# The first of three free ports, below those that the kernel gives away.
free_ports() {
    local port
    for _ in {1..50}; do
        port=$((20000 + RANDOM % 12000))
        if is_free $port && is_free $((port + 1)) && is_free $((port + 2)); then
            echo $port
            return
        fi
    done
    fail "no free ports"
}

# A scheduler that looks at once, and nodes that count as down soon after they have gone silent.
configuration() {
    local host port
    host=$(hostname -s)
    port=$(free_ports)
    cat <<END
ClusterName=testat
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$state/munge.socket
CryptoType=crypto/munge
StateSaveLocation=$state/saved
SlurmdSpoolDir=$state/spool.%n
SlurmctldPidFile=$state/slurmctld.pid
SlurmdPidFile=$state/slurmd.%n.pid
SlurmctldLogFile=$state/slurmctld.log
SlurmdLogFile=$state/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
MpiDefault=none
ReturnToService=2
MinJobAge=2
SlurmdTimeout=5
KillWait=2
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 RealMemory=1000 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 RealMemory=1000 State=UNKNOWN
PartitionName=main Nodes=n1,n2 Default=YES State=UP
END
}

# lives PID PROGRAM. Not every container's first process buries the dead.
lives() { [[ $(cat "/proc/$1/comm" 2>/dev/null) == "$2" ]] && ! grep -qs '^State:.Z' "/proc/$1/status"; }

# runs NAME PROGRAM: PROGRAM lives as STATE/NAME.pid says.
runs() {
    local pid
    pid=$(cat -- "$state/$1.pid" 2>/dev/null) && lives "$pid" "$2"
}

# start NAME COMMAND...: unless it runs. Daemons keep no hold of our output.
start() {
    local name=$1
    shift
    runs "$name" "$(basename -- "$1")" || "$@" >"$state/$name.start.log" 2>&1 </dev/null || fail "$1 does not start"
}

# The folder is ours: --down removes all of it.
is_ours() { [[ -O $state ]] && grep -qx ClusterName=testat "$SLURM_CONF" 2>/dev/null; }
is_empty() { [[ -O $state && -z $(ls -A -- "$state") ]]; }
claim() {
    mkdir -p -- "$(dirname -- "$state")"
    mkdir -- "$state" 2>/dev/null || is_ours || is_empty || {
        say "$state holds other things, or is somebody else's; choose a new folder"
        exit 2
    }
}

idle_nodes() { sinfo --noheader --Node --format=%T 2>/dev/null | grep -cx -e idle -e allocated -e mixed || true; }

up() {
    local program
    for program in munged slurmctld slurmd sinfo; do
        command -v "$program" >/dev/null || fail "$program is not installed; ci/setup.sh installs it"
    done
    claim
    [[ -s $SLURM_CONF ]] || configuration >"$SLURM_CONF"
    mkdir -p -- "$state"/{saved,spool.n1,spool.n2}
    if [[ ! -s $state/munge.key ]]; then
        (umask 077 && head -c 1024 /dev/urandom >"$state/munge.key")
    fi
    # Forced, because it wants everybody to reach its socket, and a temporary folder may be private.
    start munged munged --force --key-file="$state/munge.key" --socket="$state/munge.socket" \
        --pid-file="$state/munged.pid" --log-file="$state/munged.log" --seed-file="$state/munge.seed"
    start slurmctld slurmctld
    start slurmd.n1 slurmd -N n1
    start slurmd.n2 slurmd -N n2
    for _ in {1..150}; do
        if (($(idle_nodes) == 2)); then
            printf 'export SLURM_CONF=%q\n' "$SLURM_CONF"
            return
        fi
        sleep 0.2
    done
    fail "the nodes do not come up"
}

# end NAME PROGRAM: asks it to, and waits. Its file goes before it does.
end() {
    local pid
    runs "$1" "$2" || return 0
    pid=$(cat -- "$state/$1.pid")
    kill -- "$pid" 2>/dev/null || true
    for _ in {1..100}; do
        lives "$pid" "$2" || return 0
        sleep 0.1
    done
    kill -KILL -- "$pid" 2>/dev/null || true
}

# Steps outlive the node that started them.
end_steps() {
    local process
    for process in /proc/[0-9]*; do
        if [[ $(cat "$process/comm" 2>/dev/null) == slurmstepd ]] &&
            tr '\0' '\n' <"$process/environ" 2>/dev/null | grep -qxF "SLURM_CONF=$SLURM_CONF"; then
            kill -KILL "${process#/proc/}" 2>/dev/null || true
        fi
    done
}

down() {
    is_ours || return 0
    if runs slurmctld slurmctld; then
        timeout 10 scancel --user="$(id -un)" 2>/dev/null || true
    fi
    end slurmd.n1 slurmd &
    end slurmd.n2 slurmd &
    wait
    end_steps
    end slurmctld slurmctld
    end munged munged
    rm -rf -- "$state"
}

action=up state=
for argument in "$@"; do
    case $argument in
        --down) action=down ;;
        --help | -h) usage && exit 0 ;;
        -*) say "unknown option $argument" && exit 2 ;;
        *) state=$argument ;;
    esac
done
state=$(realpath -m -- "${state:-${TMPDIR:-/tmp}/testat-slurm-$(id -u)}")
[[ $state != *[[:space:]]* ]] || { say "Slurm knows no folders with spaces: $state" && exit 2; }
export SLURM_CONF=$state/slurm.conf
$action
