#!/bin/sh
# Installs a build tree by cmake --install; then builds a project that knows only the prefix: find_package(kinegraph),
# kinegraph::kinegraph.
#   install_test.sh BUILD_DIRECTORY
set -eu
build=$1
here=$(cd "$(dirname -- "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >"$work/log"
for file in bin/kinegraph share/kinegraph/mechanism.schema.json share/man/man1/kinegraph.1; do
    test -s "$work/prefix/$file" || { echo "not installed: $file"; exit 1; }
done
"$work/prefix/bin/kinegraph" --version

# The installed program finds its modules, and does not link their libraries directly.
"$work/prefix/bin/kinegraph" solve "$here/../examples/four_bar.json" -o "$work/a.svg" -o "$work/a.png" -o "$work/a.pdf"
"$work/prefix/bin/kinegraph" solve "$here/../examples/four_bar.json" -o "$work/live.svg" --text live
"$work/prefix/bin/kinegraph" solve "$here/../examples/motion/projectile.json" -o "$work/a.json"
"$work/prefix/bin/kinegraph" variants "$here/../examples/variants/four_bar.json" --count 1 --for qti -o "$work/class"
if ldd "$work/prefix/bin/kinegraph" | grep -E 'libcairo|libX11|libharfbuzz|libginac|libcln|libzip|libcrypto'; then echo "the program loads what it draws with at every start"; exit 1; fi

cmake -S "$here/install_test" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Release
cmake --build "$work/build"
"$work/build/consumer"
