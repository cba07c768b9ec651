#!/bin/sh
# Tests the launcher (./kinegraph) with a stand-in for the build: when it builds, which arguments it passes to the
# program, what goes to standard output. tests/run does a real build.
set -u
root=$1
tree=$(mktemp -d)
trap 'rm -r "$tree"' EXIT
failed=0

same() {
    if [ "$2" != "$3" ]; then
        printf '%s: expected "%s", got "%s"\n' "$1" "$2" "$3"
        failed=1
    fi
}

# A clone with sources, tools that only record their calls, and a program that prints its arguments.
top="$tree/a clone"
mkdir -p "$top/engine/board" "$top/render/live/deep/deeper" "$tree/tools" "$tree/elsewhere"
cp -r "$root/kinegraph" "$root/cmake" "$top/"
touch "$top/CMakeLists.txt" "$top/engine/board/board.cpp"
cat >"$tree/tools/dpkg-query" <<'TXT'
#!/bin/sh
shift 3
for package in "$@"; do echo "installed $package"; done
TXT
cat >"$tree/tools/cmake" <<'TXT'
#!/bin/sh
echo "progress of cmake $1"
cat
case $1 in
    -S)
        echo configured >>"$TREE/configurations"
        touch "$4/CMakeCache.txt"
        [ -e "$TREE/unconfigurable" ] && exit 1
        touch "$4/build.ninja"
        ;;
    --build)
        echo built >>"$TREE/builds"
        [ -e "$TREE/broken" ] && exit 1
        cat >"$2/kinegraph" <<'PROGRAM'
#!/bin/sh
printf '%s|' "${PWD##*/}" "$@"
[ "${1-}" = - ] && cat
exit 3
PROGRAM
        chmod +x "$2/kinegraph"
        ;;
esac
TXT
chmod +x "$tree/tools/"*
export TREE="$tree" PATH="$tree/tools:$PATH"
builds() { grep -c built "$tree/builds"; }
later() { touch -d "$1" "$2"; }

cd "$tree/elsewhere" || exit 1
out=$(echo text | "../a clone/kinegraph" - "two words" 2>"$tree/err")
same "status of the program" 3 $?
same "first call: directory, arguments, standard input" "elsewhere|-|two words|text" "$out"
same "first call builds once" 1 "$(builds)"
same "progress goes to standard error" 1 "$(grep -c 'progress of cmake --build' "$tree/err")"

out=$("../a clone/kinegraph" solve ../f.json 2>"$tree/err")
same "second call" "elsewhere|solve|../f.json|" "$out"
same "second call does not build" 1 "$(builds)"
same "second call is silent" "" "$(cat "$tree/err")"

ln -s "../a clone/kinegraph" "$tree/elsewhere/kg"
same "through a link" "elsewhere|x|" "$(./kg x 2>&1)"
same "through PATH" "elsewhere|x|" "$(PATH="$top:$PATH" kinegraph x 2>&1)"
same "from its own directory" "a clone|x|" "$(cd "$top" && sh kinegraph x 2>&1)"
same "none of these builds" 1 "$(builds)"

later "1 minute" "$top/engine/board/board.cpp"
"$top/kinegraph" x >/dev/null 2>&1
same "a newer source builds" 2 "$(builds)"
later "1 minute ago" "$top/engine/board/board.cpp"
"$top/kinegraph" x >/dev/null 2>&1
same "then no more" 2 "$(builds)"

touch "$top/render/live/deep/deeper/new.js"
later "1 minute" "$top/render/live/deep/deeper/new.js"
"$top/kinegraph" x >/dev/null 2>&1
same "a new file in a deep folder builds" 3 "$(builds)"
later "1 minute ago" "$top/render/live/deep/deeper/new.js"
later "1 minute" "$top/render/live/deep/deeper"
"$top/kinegraph" x >/dev/null 2>&1
same "so does a folder that lost a file" 4 "$(builds)"
later "1 minute ago" "$top/render/live/deep/deeper"

# The launcher checks every top-level folder from which the real build takes a file.
folders=$(cd "$root" && find . -maxdepth 1 -mindepth 1 -type d ! -name '.*' ! -name 'build*' | sed 's|^\./||' | sort)
taken=$(cd "$root" && for folder in $folders; do
    if grep -qE "(^|[ (/\"])$folder/" CMakeLists.txt cmake/*.cmake && [ "$folder" != tests ] && [ "$folder" != docs ] &&
        [ "$folder" != examples ] && [ "$folder" != bench ] && [ "$folder" != python ] &&
        [ "$folder" != packaging ]; then echo "$folder"; fi
done)
[ -n "$taken" ] || same "folders of the build are found" some none
for folder in $taken; do
    if grep -q "\"\$top\"/$folder" "$root/kinegraph"; then seen=yes; else seen=no; fi
    same "the launcher looks into $folder" yes "$seen"
done

same "one configuration serves all builds" 1 "$(grep -c . "$tree/configurations")"

rm -r "$top/build"
touch "$tree/unconfigurable"
"$top/kinegraph" x >/dev/null 2>&1
same "a failed configuration is our fault" 70 $?
rm "$tree/unconfigurable"
"$top/kinegraph" x >/dev/null 2>&1
same "and is tried again" 3 $?

touch "$tree/broken"
rm "$top/build/kinegraph"
out=$("$top/kinegraph" x 2>/dev/null)
same "a failed build is our fault" 70 $?
same "and prints no result" "" "$out"
exit $failed
