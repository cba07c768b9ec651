#!/bin/bash
# Many variants of each teaching example in examples/variants: each solved, its conditions held against the numeric check, its
# question and its solution without a fault of the page checker. The suite looks at a few; this, once, at as many as are asked for.
#   variants_bench.sh [TESTS] [COUNT]
set -u
top=$(cd "$(dirname "$0")/.." && pwd)
tests=${1:-$top/build/tests/kinegraph_tests} count=${2:-120}
[ -x "$tests" ] || { echo "$tests is not there: build the tests first" >&2; exit 2; }
KINEGRAPH_VARIANTS=$count exec "$tests" \
    --gtest_filter='Variants.OfEveryTeachingExampleAreSolvedAndMeetTheirConditionsByTheCheck:Variants.HaveSheetsWithoutFaults'
