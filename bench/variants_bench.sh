#!/bin/bash
# Solves many variants of each teaching example in examples/variants, compares their conditions with the numeric check,
# and runs the page checker on each question and solution. The test suite does this for a few variants; this script for
# as many as requested.
#   variants_bench.sh [TESTS] [COUNT]
set -u
top=$(cd "$(dirname "$0")/.." && pwd)
tests=${1:-$top/build/tests/kinegraph_tests} count=${2:-120}
[ -x "$tests" ] || { echo "$tests is not there: build the tests first" >&2; exit 2; }
KINEGRAPH_VARIANTS=$count exec "$tests" \
    --gtest_filter='Variants.OfEveryTeachingExampleAreSolvedAndMeetTheirConditionsByTheCheck:Variants.HaveSheetsWithoutFaults'
