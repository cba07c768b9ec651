#!/bin/bash
# Times whole commands from start to end of the process, on one processor: median and best of RUNS, and the peak memory
# by GNU time, if installed. "nothing" is a process that only starts and ends.
#   program_bench.sh [PROGRAM] [RUNS]
set -u
export LC_ALL=C
top=$(cd "$(dirname "$0")/.." && pwd)
program=${1:-$top/build/kinegraph}
runs=${2:-50}
example=$top/examples/four_bar.json
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT
[ -x "$program" ] || { echo "$program is not there: build it first" >&2; exit 2; }
command -v taskset >/dev/null && taskset -p -c 0 $$ >/dev/null 2>&1

# measure NAME COMMAND…: prints one row of the table.
measure() {
    local name=$1 start end memory=-
    shift
    "$@" >/dev/null 2>&1 || { echo "$name: status $?" >&2; return; }
    for ((run = 0; run < runs; ++run)); do
        start=${EPOCHREALTIME/./}
        "$@" >/dev/null 2>&1
        end=${EPOCHREALTIME/./}
        echo $((end - start))
    done | sort -n >"$folder/times"
    if [ -x /usr/bin/time ]; then
        memory=$(/usr/bin/time -q -f %M -o "$folder/memory" "$@" >/dev/null 2>&1; tail -n 1 "$folder/memory")
        memory=$(awk -v kib="$memory" 'BEGIN { printf "%.1f", kib / 1024 }')
    fi
    awk -v name="$name" -v memory="$memory" '{ t[NR] = $1 / 1000 }
        END { printf "%-28s %8.1f %8.1f %10s\n", name, t[int((NR + 1) / 2)], t[1], memory }' "$folder/times"
}

printf '%-28s %8s %8s %10s\n' "command" "median" "best" "memory"
printf '%-28s %8s %8s %10s\n' "" "ms" "ms" "MiB"
measure "nothing" /bin/true
measure "--version" "$program" --version
measure "check" "$program" check "$example"
measure "solve: table" "$program" solve "$example"
measure "solve: JSON" "$program" solve "$example" -o "$folder/a.json"
measure "solve: SVG, A4" "$program" solve "$example" -o "$folder/a.svg"
measure "solve: PDF, A4" "$program" solve "$example" -o "$folder/a.pdf"
measure "solve: PNG, A4, 150 dpi" "$program" solve "$example" -o "$folder/a.png" --dpi 150
measure "sweep: CSV, 360 steps" "$program" sweep "$example" -o "$folder/c.csv"
measure "sweep: CSV, 10000 steps" "$program" sweep "$example" --steps 10000 -o "$folder/c.csv"
measure "sweep: SVG, A4" "$program" sweep "$example" -o "$folder/c.svg"
measure "cam: CSV, 360 steps" "$program" cam "$top/examples/cams/disc_cam.json" -o "$folder/c.csv"
for path in "$top"/examples/*.json; do
    name=$(basename "$path" .json)
    [ "$name" = slider_driven_dead_point ] || [ "$name" = four_bar ] || measure "SVG of $name" "$program" solve "$path" -o "$folder/b.svg"
done
