#!/bin/bash
# The rows of docs/performance.md about the built program, as Markdown: medians of RUNS whole commands, from start to
# end of the process. The rows about the build are the times of the commands that they name.
#   table.sh [PROGRAM] [RUNS]
set -u
export LC_ALL=C
top=$(cd "$(dirname "$0")/.." && pwd)
program=$(readlink -f "${1:-$top/build/kinegraph}")
runs=${2:-20}
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
cd "$folder" || exit 2
[ -x "$program" ] || { echo "$program is not there: build it first" >&2; exit 2; }

# median COMMAND…: the median wall-clock time in microseconds.
median() {
    local start end
    "$@" >answers 2>messages </dev/null || { echo "status $? of $*" >&2; cat messages >&2; exit 1; }
    for ((run = 0; run < runs; ++run)); do
        start=${EPOCHREALTIME/./}
        "$@" >answers 2>messages </dev/null
        end=${EPOCHREALTIME/./}
        echo $((end - start))
    done | sort -n | awk '{ t[NR] = $1 } END { print t[int((NR + 1) / 2)] }'
}

row() {
    local name=$1 time
    shift
    time=$(median "$@") || exit 1
    awk -v name="$name" -v time="$time" 'BEGIN { printf "| %s | %.1f ms |\n", name, time / 1000 }'
}

# lines NAME COUNT ARGUMENTS-OF-requests.sh…: the lines of batch that one worker answers in a second.
lines() {
    local name=$1 count=$2 time
    shift 2
    "$top/examples/cluster/requests.sh" "$count" "$top/examples/cluster/four_bar.json" "$@" >requests.jsonl
    time=$(runs=3 median sh -c "rm -rf out; exec '$program' batch --jobs 1 <requests.jsonl") || exit 1
    awk -v name="$name" -v time="$time" -v count="$count" \
        'BEGIN { printf "| %s | %.0f a second |\n", name, count / (time / 1e6) }'
}

for example in four_bar watt_six_bar exam_2001; do
    for kind in svg png; do
        row "\`solve examples/$example.json -o out.$kind\`" "$program" solve "$top/examples/$example.json" -o out.$kind
    done
done
row '`solve examples/four_bar.json -o out.json`' "$program" solve "$top/examples/four_bar.json" -o out.json
row '`sweep examples/four_bar.json -o out.csv`, 361 rows' "$program" sweep "$top/examples/four_bar.json" -o out.csv
lines '`batch --jobs 1`, results in the answer' 3000
lines '`batch --jobs 1`, A4 sheets as SVG in files' 300 svg
