#!/bin/bash
# `kinegraph batch`: answers a second for each processor, with one worker and with two, and the peak memory. The lines
# are different variants of the four-bar in examples/cluster. The memory is measured by GNU time, if installed.
#   batch_bench.sh [PROGRAM] [LINES] [SHEETS]
set -u
export LC_ALL=C
top=$(cd "$(dirname "$0")/.." && pwd)
program=$(readlink -f "${1:-$top/build/kinegraph}")
lines=${2:-10000} sheets=${3:-1000}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder" || exit 2
[ -x "$program" ] || { echo "$program is not there: build it first" >&2; exit 2; }

# measure NAME LINES JOBS ARGUMENTS-OF-requests.sh…: prints one row.
measure() {
    local name=$1 count=$2 jobs=$3 start end before after memory=-
    shift 3
    "$top/examples/cluster/requests.sh" "$count" "$top/examples/cluster/four_bar.json" "$@" >requests.jsonl
    rm -rf out
    local prefix=()
    [ -x /usr/bin/time ] && prefix=(/usr/bin/time -q -f %M -o memory)
    before=$(awk '{ print $16 + $17 }' /proc/$$/stat)
    start=${EPOCHREALTIME/./}
    "${prefix[@]}" "$program" batch --jobs "$jobs" <requests.jsonl >answers.jsonl || exit 1
    end=${EPOCHREALTIME/./}
    after=$(awk '{ print $16 + $17 }' /proc/$$/stat)
    [ "$(grep -c '"status": 0, ' answers.jsonl)" = "$count" ] || { echo "$name: not all are solved" >&2; exit 1; }
    [ -s memory ] && memory=$(tail -n 1 memory)
    awk -v name="$name" -v count="$count" -v jobs="$jobs" -v wall=$((end - start)) -v cpu=$((after - before)) \
        -v ticks="$(getconf CLK_TCK)" -v memory="$memory" 'BEGIN {
        printf "%-32s %4d %6d %9.1f %12.0f %16.0f %9.1f\n", name, jobs, count, wall / 1e6, count / (wall / 1e6),
            count / (cpu / ticks), memory / 1024 }'
}

printf '%-32s %4s %6s %9s %12s %16s %9s\n' "" jobs lines "wall, s" "a second" "a second of CPU" "MiB"
for jobs in 1 2; do
    measure "results in the answer" "$lines" "$jobs"
    measure "results in files" "$lines" "$jobs" json
    measure "A4 sheets, SVG in files" "$sheets" "$jobs" svg
    measure "A4 sheets, PDF in files" "$sheets" "$jobs" pdf
done
measure "a tenth of the sheets, for memory" $((sheets / 10)) 1 svg
