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
for file in bin/kinegraph share/kinegraph/mechanism.schema.json share/man/man1/kinegraph.1 \
    share/man/man1/kinegraph-solve.1 share/bash-completion/completions/kinegraph \
    share/zsh/vendor-completions/_kinegraph share/fish/vendor_completions.d/kinegraph.fish \
    share/applications/kinegraph.desktop share/mime/packages/kinegraph.xml \
    share/icons/hicolor/scalable/apps/kinegraph.svg share/metainfo/org.kinegraph.Kinegraph.metainfo.xml; do
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

# The two example programs: against the installed library, and as a program that has the source tree for a subproject. (There
# only the program is compiled: the library is the one that was built here.)
cmake -S "$here/../examples/library" -B "$work/examples" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Release
cmake --build "$work/examples"
"$work/examples/solve_and_draw" "$here/../examples/four_bar.json" "$work/sheet.svg" >"$work/omegas"
grep -q '^omega 3 = ' "$work/omegas"
cmp "$work/sheet.svg" "$work/a.svg"
"$work/examples/class_of_variants" "$here/../examples/variants/four_bar.json" 4 >"$work/class_of_four"
grep -q '^4: ' "$work/class_of_four"
cmake -S "$here/../examples/library" -B "$work/subproject" -G Ninja -DKINEGRAPH_SOURCE="$here/.." -DCMAKE_BUILD_TYPE=Release
ninja -C "$work/subproject" CMakeFiles/solve_and_draw.dir/solve_and_draw.cpp.o

# The shared library shows the public face and nothing else, and the example program draws the same with it.
cmake --build "$build" --target kinegraph_shared
nm -DC --defined-only "$build/libkinegraph.so" | grep -v ' A ' | grep -v 'kinegraph::' && { echo "these are no names of the public face"; exit 1; }
nm -D --defined-only "$build/libkinegraph.so" | awk '{print $NF}' | sort >"$work/shown"
c++ -std=c++20 -c -DKINEGRAPH_EXAMPLES_DIR='""' -I"$here/../include" "$here/app/library_test.cpp" -o "$work/library_test.o"
nm -u "$work/library_test.o" | awk '/_ZN?K?9kinegraph/ {print $NF}' | sort >"$work/needed"
test -s "$work/needed"
if comm -13 "$work/shown" "$work/needed" | c++filt | grep .; then echo "not in cmake/exported_symbols.map"; exit 1; fi
c++ -std=c++20 -I"$here/../include" "$here/../examples/library/solve_and_draw.cpp" "$build/libkinegraph.so" -o "$work/with_shared"
LD_LIBRARY_PATH="$build" "$work/with_shared" "$here/../examples/four_bar.json" "$work/shared.svg" >/dev/null
cmp "$work/shared.svg" "$work/a.svg"

# pkg-config finds it too.
PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name kinegraph.pc)") pkg-config --exists 'kinegraph >= 0.1'
test "$(PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name kinegraph.pc)") pkg-config --variable=prefix kinegraph |
    xargs realpath)" = "$(realpath "$work/prefix")"

# What the face asks of a program that includes it all.
lines=$(echo '#include <kinegraph/kinegraph.hpp>' | c++ -std=c++20 -I"$work/prefix/include" -E -x c++ - | wc -l)
if [ "$lines" -gt 60000 ]; then echo "the public face preprocesses to $lines lines"; exit 1; fi
headers=$(find "$work/prefix/include" -name '*.hpp' | wc -l)
if [ "$headers" -gt 10 ]; then echo "$headers headers are installed"; exit 1; fi
