#!/bin/bash
# Runs examples/cluster/ with the real tool on this machine: 10,000 variants, a worker killed on the way; the answers
# equal those of one process, byte for byte. Without the tool's Debian package the test is skipped (77).
#   cluster_test.sh reference PROGRAM FOLDER         makes the requests, and their answers by one process
#   cluster_test.sh parallel|slurm|dask PROGRAM FOLDER
# CLUSTER_REQUESTS: the number of requests, for a trial by hand.
set -u
engine=$1 program=$(readlink -f "$2") folder=$3
here=$(cd "$(dirname "$0")/../examples/cluster" && pwd)
count=${CLUSTER_REQUESTS:-10000}

if [ "$engine" = reference ]; then
    rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" || exit 1
    "$here/requests.sh" "$count" "$here/four_bar.json" >requests.jsonl
    "$program" batch <requests.jsonl >one.jsonl || exit 1
    # All are solved, and all differ.
    [ "$(grep -c '"status": 0, ' one.jsonl)" = "$count" ] || { echo "not all are solved"; exit 1; }
    [ "$(sed 's/"id": [0-9]*//' one.jsonl | sort -u | wc -l)" = "$count" ] || { echo "not all are different"; exit 1; }
    exit 0
fi

work=$(mktemp -d /tmp/kinegraph-cluster-XXXXXX)
started=()
finish() {
    for ((i = ${#started[@]}; i-- > 0;)); do kill "${started[i]}" 2>/dev/null; done
    wait
    rm -rf "$work"
}
trap finish EXIT
trap 'exit 1' INT TERM
cd "$work" || exit 1

# A wrapper of the program under its name, in the test's own PATH. It records each start: its process id and its
# parent's.
mkdir bin
printf '#!/bin/sh\necho $$ $PPID >>"%s/starts"\nexec "%s" "$@"\n' "$work" "$program" >bin/kinegraph
chmod +x bin/kinegraph
export PATH="$work/bin:$PATH"
: >starts

# kill_one FIELD: when some blocks have started, kills the process (1) or the parent process (2) of the next one.
kill_one() {
    local line pid
    until [ "$(wc -l <starts)" -ge "$((1 + count / 2000))" ]; do sleep 0.02; done
    while :; do
        line=$(tail -n 1 starts)
        pid=$(cut -d ' ' -f "$1" <<<"$line")
        # The process is alive and at work on its block: a zombie is neither.
        if grep -q '^State:[[:space:]]*[RSD]' "/proc/$pid/status" 2>/dev/null && kill -9 "$pid" 2>/dev/null; then
            echo "$line" >killed
            return
        fi
        sleep 0.02
    done
}

by_parallel() {
    kill_one 1 & started+=($!)
    "$here/parallel.sh" -j 2 <"$folder/requests.jsonl" >answers.jsonl
}

by_dask() {
    /usr/bin/python3 -c 'import distributed' 2>/dev/null || exit 77
    kill_one 2 & started+=($!)
    export DASK_DISTRIBUTED__WORKER__USE_FILE_LOCKING=false DASK_TEMPORARY_DIRECTORY="$work"
    /usr/bin/python3 "$here/dask_batch.py" <"$folder/requests.jsonl" >answers.jsonl 2>dask.log
}

# A cluster of one node with its own key, ports and folders.
start_slurm() {
    local name user port
    name=$(hostname -s) user=$(id -un) port=$((20000 + $$ % 20000))
    mkdir munge state spool
    chmod 755 "$work"
    head -c 128 /dev/urandom >munge/key
    chmod 600 munge/key
    cat >slurm.conf <<CONF
ClusterName=kinegraph
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
SlurmUser=$user
SlurmdUser=$user
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=bf_interval=1,sched_interval=1,sched_min_interval=0,batch_sched_delay=0
MpiDefault=none
ReturnToService=2
NodeName=$name NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
    export SLURM_CONF=$work/slurm.conf
    munged --force --foreground --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge/pid" \
        --log-file="$work/munge/log" --seed-file="$work/munge/seed" 2>munge.log & started+=($!)
    slurmctld -D -f slurm.conf 2>/dev/null & started+=($!)
    slurmd -D -f slurm.conf 2>/dev/null & started+=($!)
    for ((i = 0; i < 150; ++i)); do
        [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && return
        sleep 0.2
    done
    echo "Slurm does not start:"
    tail -n 5 munge.log slurmctld.log slurmd.log
    exit 1
}

by_slurm() {
    PATH=$PATH:/usr/sbin
    start_slurm
    kill_one 2 & started+=($!)
    "$here/slurm.sh" "$folder/requests.jsonl" "$work/shared" 12 >slurm.log 2>&1
    cp shared/answers.jsonl answers.jsonl
}

case $engine in
parallel) tools=parallel ;;
slurm) tools="sbatch slurmctld slurmd munged" ;;
dask) tools=/usr/bin/python3 ;;
*) echo "no engine $engine" && exit 2 ;;
esac
for tool in $tools; do PATH=$PATH:/usr/sbin command -v "$tool" >/dev/null || exit 77; done

"by_$engine" || { echo "$engine ends with status $?"; cat ./*.log; exit 1; }
[ -s killed ] || { echo "no worker was killed"; exit 1; }
cmp answers.jsonl "$folder/one.jsonl" || exit 1
echo "$(wc -l <answers.jsonl) answers by $(wc -l <starts) workers, of which one was killed ($(cat killed)): as by one process"
