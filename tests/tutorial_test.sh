#!/bin/sh
# Runs docs/tutorial.md literally: writes its files and executes its commands in an empty folder, in order.
#   tutorial_test.sh PROGRAM ROOT
# A block after `<!-- file: NAME -->` is written to NAME. A block ```sh is executed; its exit status must be 0, or that
# of a line `<!-- status: N -->` before it. Every line of a block ```text must be in the output of the last block
# executed.
set -u
program=$1
tutorial=$(cd "$2" && pwd)/docs/tutorial.md
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
PATH=$(cd "$(dirname -- "$program")" && pwd):$PATH
export PATH

# blocks TUTORIAL FOLDER: writes its blocks to numbered files, and a list of actions, one on each line: "NUMBER ACTION
# DETAIL".
blocks() {
    mkdir "$2"
    awk -v folder="$2" '
        /^<!-- file: .* -->$/ { name = $3; next }
        /^<!-- status: [0-9]+ -->$/ { status = $3; next }
        /^```/ && !inside {
            kind = substr($0, 4); inside = 1; ++count
            block = sprintf("%s/%03d", folder, count)
            if (name != "") action = "write " name
            else if (kind == "sh") action = "run " (status == "" ? 0 : status)
            else if (kind == "text") action = "expect -"
            else { print "a block of \"" kind "\" without a name" >"/dev/stderr"; exit 1 }
            printf "%03d %s\n", count, action
            name = status = ""; printf "" >block
            next
        }
        /^```$/ { inside = 0; close(block); next }
        inside { print >block }
    ' "$1" >"$2/list"
}

# follow FOLDER: writes, runs and compares in an empty folder; prints the differences.
follow() {
    rm -rf "$work/empty" && mkdir "$work/empty" && cd "$work/empty" || return 1
    runs=0
    expectations=0
    while read -r number action detail; do
        block=$1/$number
        case $action in
            write) cp "$block" "$detail" ;;
            run)
                runs=$((runs + 1))
                sh -e "$block" >"$work/output" 2>&1 </dev/null
                status=$?
                if [ $status != "$detail" ]; then
                    printf 'status %s where %s is expected of:\n' $status "$detail"
                    cat "$block" "$work/output"
                    return 1
                fi
                ;;
            expect)
                expectations=$((expectations + 1))
                while IFS= read -r line; do
                    grep -qxF -e "$line" "$work/output" && continue
                    printf 'not in the output of the command before: %s\n' "$line"
                    cat "$work/output"
                    return 1
                done <"$block"
                ;;
        esac
    done <"$1/list"
    if [ $runs -lt 10 ] || [ $expectations -lt 5 ]; then
        echo "only $runs commands, $expectations outputs were found"
        return 1
    fi
}

blocks "$tutorial" "$work/blocks" && follow "$work/blocks" || exit 1

# The test finds a wrong number and a wrong status.
for change in 's/^  M       19.6141  N m/  M       19.6142  N m/' 's/^<!-- status: 2 -->/<!-- status: 0 -->/'; do
    sed "$change" "$tutorial" >"$work/changed.md"
    cmp -s "$tutorial" "$work/changed.md" && { echo "nothing to change by $change"; exit 1; }
    rm -rf "$work/changed"
    if blocks "$work/changed.md" "$work/changed" && follow "$work/changed" >/dev/null; then
        echo "unseen: $change"
        exit 1
    fi
done
exit 0
