#!/bin/sh
# Requests by an array of Slurm: each task takes a part of whole lines. Parts that are missing when all tasks have ended, because
# a task was killed or its node was lost, are submitted again, three times at most; an answer file is whole or not there.
#   slurm.sh REQUESTS.jsonl FOLDER [PARTS] [arguments of sbatch]      → FOLDER/answers.jsonl
# FOLDER is one that all nodes see. A call that was broken off is simply given again.
set -eu
requests=$1 folder=$2 parts=${3:-20}
shift "$(($# < 3 ? $# : 3))"
mkdir -p "$folder"
split -n "l/$parts" -d -a 5 "$requests" "$folder/part-"
numbers=$(seq 0 $((parts - 1)))
missing() { for n in $numbers; do [ -e "$(printf '%s/answers-%05d' "$folder" "$n")" ] || echo "$n"; done | paste -sd, -; }

for turn in 1 2 3; do
    [ -n "$(missing)" ] || break
    FOLDER=$folder sbatch --wait --array="$(missing)" --output=/dev/null "$@" <<'TASK' || true
#!/bin/sh
n=$(printf %05d "$SLURM_ARRAY_TASK_ID")
kinegraph batch --resume <"$FOLDER/part-$n" >"$FOLDER/new-$n.$SLURM_JOB_ID" && mv "$FOLDER/new-$n.$SLURM_JOB_ID" "$FOLDER/answers-$n"
TASK
done
[ -z "$(missing)" ] || { echo "parts without answers: $(missing)" >&2; exit 1; }
cat "$folder"/answers-[0-9]* >"$folder/answers.jsonl"
