#!/bin/sh
# The public headers are documented: doxygen gives no warning.
#   reference_test.sh ROOT
set -eu
cd "$1"
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
(cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $work") | doxygen - >"$work/log" 2>&1
if grep -E 'warning|error' "$work/log"; then exit 1; fi
test -s "$work/html/index.html"
# doxygen warns of a header with an undocumented function, so the test can fail.
mkdir "$work/bare"
printf '/// \\file\n/// A file.\n#pragma once\n/// A class.\nstruct Documented {\n    int undocumented() const;\n};\n' \
    >"$work/bare/bare.hpp"
(cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = $work"; echo "INPUT = $work/bare") | doxygen - >"$work/log" 2>&1
grep -q 'undocumented.*is not documented' "$work/log" || { echo "an undocumented function was not noticed"; exit 1; }
