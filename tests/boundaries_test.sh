#!/bin/sh
# Holds the walls between the rooms: app → render → engine, app → constructions → engine; the floors of render, each of which
# knows those below it; CGAL in at most two files of the engine, Eigen in the two checks alone, cairo in its backend alone; the
# kinds of joint known by name to the table of pairs and the check alone.
#   boundaries_test.sh ROOT         every breach in the tree, one a line; status 1 if there is one
#   boundaries_test.sh --self-test  that each kind of breach is seen
set -u

# includes PATTERN ROOM…: file:line:text of the includes that match, of all that `check` has listed.
includes() {
    pattern=$1
    shift
    within=$(printf '%s|' "$@")
    printf '%s\n' "$all" | grep -E "^(${within%|})/[^:]*:[0-9]+:[[:space:]]*#[[:space:]]*include[[:space:]]*$pattern"
}

breach() { sed "s|\$|   <- $1|"; }

# floor ROOM BELOW…: the includes by which a room of render knows another one than those below it.
floor() {
    room=$1
    known=$(printf '|%s' "$@")
    shift
    includes '["<]render/' "render/$room" | grep -vE "include[[:space:]]*[\"<]render/(${known#|})/" |
        breach "of render's rooms $room knows ${*:-itself alone}"
}

check() {
    cd "$1" || return 2
    rooms="engine constructions render app tests bench"
    # shellcheck disable=SC2086 # lists of words
    all=$(find $rooms -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' \) 2>/dev/null | sort |
        xargs -r grep -nHE '^[[:space:]]*#[[:space:]]*include')
    # shellcheck disable=SC2086 # lists of words
    found=$(
        includes '["<](constructions|render|app|tests|bench)/' engine | breach "engine knows no other room"
        includes '["<](render|app|tests|bench)/' constructions | breach "constructions knows the engine alone"
        includes '["<](app|tests|bench)/' render | breach "render knows nothing of app"
        includes '["<]constructions/' render | breach "render needs no construction"
        floor ink
        floor text ink
        floor page ink text
        floor backends ink text page
        floor scene ink text page
        floor tables ink text page scene
        floor mechanism ink text page scene tables
        floor figures ink text page scene tables mechanism
        floor sheet ink text page scene tables mechanism figures
        floor live ink text page scene tables mechanism figures sheet backends
        includes '["<](tests|bench)/' app | breach "app knows nothing of tests"
        includes '"' $rooms | grep -vE 'include[[:space:]]*"(engine|constructions|render|app|tests|bench)/[a-z]' |
            breach "own headers are written from the root, room first"
        includes '[<"](unsupported/)?Eigen/' $rooms | grep -vE '^engine/(check(_forces|_hertz)?\.cpp|numeric/[a-z_]*\.[ch]pp):' |
            breach "Eigen is the checks': engine/check.cpp's and those of its like"
        includes '["<]engine/numeric/' $rooms | grep -vE '^engine/(check|numeric/)' | breach "engine/numeric is the checks' alone"
        includes '[<"](cairo/)?cairo' $rooms | grep -v '^render/backends/cairo_backend\.cpp:' |
            breach "cairo is render/backends/cairo_backend.cpp's"
        includes '[<"]hb' $rooms | grep -vE '^render/text/(typeface|subset)\.cpp:' |
            breach "HarfBuzz is render/text/typeface.cpp's and subset.cpp's"
        includes '<sys/socket\.h>' $rooms | grep -v '^app/local_server\.cpp:' | breach "sockets are app/local_server.cpp's"
        includes '[<"](ginac|cln)/' $rooms | grep -v '^engine/algebra_ginac\.cpp:' |
            breach "GiNaC is engine/algebra_ginac.cpp's"
        includes '[<"]CGAL/' $rooms | grep -v '^engine/' | breach "CGAL is the engine's"
        users=$(includes '[<"]CGAL/' engine | cut -d: -f1 | sort -u)
        if [ "$(printf '%s' "$users" | grep -c .)" -gt 2 ]; then
            printf '%s\n' "$users" | breach "more than two files of the engine include CGAL"
        fi
        grep -rn 'JointKind::' engine constructions render app 2>/dev/null |
            grep -vE '^engine/(pair|check|check_forces|mechanism|numeric/equilibrium_equations)\.[ch]pp:' | breach "kinds of joint are engine/pair's and the check's"
    )
    [ -z "$found" ] && return 0
    printf '%s\n' "$found"
    return 1
}

# seen TEXT FILE INCLUDE [FILE INCLUDE]…: a tree with these includes is refused, saying TEXT ("" for: is accepted).
seen() {
    expected=$1
    shift
    tree=$(mktemp -d)
    while [ $# -gt 0 ]; do
        mkdir -p "$tree/${1%/*}"
        printf '#include %s\n' "$2" >>"$tree/$1"
        shift 2
    done
    said=$(check "$tree")
    rm -r "$tree"
    case $said in
        *"$expected"*) [ -n "$expected" ] || [ -z "$said" ] && return 0 ;;
    esac
    printf 'expected "%s", was told "%s"\n' "$expected" "$said"
    failed=1
}

if [ "$1" != --self-test ]; then
    check "$1"
    exit
fi
failed=0
seen "engine knows" engine/a.cpp '"constructions/b.hpp"'
seen "engine knows" engine/a.hpp '"render/b.hpp"'
seen "engine alone" constructions/a.hpp '"render/b.hpp"'
seen "nothing of app" render/a.cpp '"app/b.hpp"'
seen "needs no construction" render/page/a.cpp '"constructions/b.hpp"'
seen "ink knows itself alone" render/ink/a.hpp '"render/text/b.hpp"'
seen "page knows ink text" render/page/a.hpp '"render/figures/b.hpp"'
seen "tables knows" render/tables/a.cpp '"render/figures/b.hpp"'
seen "scene knows" render/scene/a.cpp '"render/figures/b.hpp"'
seen "figures knows" render/figures/a.cpp '"render/sheet/b.hpp"'
seen "backends knows" render/backends/a.cpp '"render/scene/b.hpp"'
seen "room first" render/a.cpp '"../app/b.hpp"'
seen "room first" engine/a.cpp '"b.hpp"'
seen "check.cpp's" engine/board.cpp '<Eigen/Dense>'
seen "check.cpp's" tests/a_test.cpp '<Eigen/Dense>'
seen "check.cpp's" engine/check_forces.hpp '<Eigen/Dense>'
seen "the checks' alone" constructions/a.cpp '"engine/numeric/b.hpp"'
seen "the checks' alone" engine/board.cpp '"engine/numeric/b.hpp"'
seen "cairo_backend.cpp's" render/text/text.cpp '<cairo/cairo.h>'
seen "cairo_backend.cpp's" app/main.cpp '<cairo-pdf.h>'
seen "algebra_ginac.cpp's" engine/expression.cpp '<ginac/ginac.h>'
seen "HarfBuzz is" render/text/text.cpp '<hb.h>'
seen "the engine's" constructions/a.cpp '<CGAL/Point_2.h>'
seen "more than two" engine/a.cpp '<CGAL/a.h>' engine/b.cpp '<CGAL/a.h>' engine/c.hpp '<CGAL/a.h>'
seen "kinds of joint" constructions/a.cpp 'JointKind::gear'
seen "" engine/pair.cpp 'JointKind::gear' engine/check_forces.cpp 'JointKind::weld' tests/a_test.cpp 'JointKind::gear'
seen "" engine/a.cpp '<CGAL/a.h>' engine/a.cpp '<CGAL/b.h>' engine/b.cpp '<CGAL/a.h>' engine/check.cpp '<Eigen/QR>' \
    engine/check_forces.cpp '<Eigen/Dense>' engine/numeric/a.hpp '<Eigen/Dense>' engine/check_forces.cpp '"engine/numeric/a.hpp"' \
    render/backends/cairo_backend.cpp '<cairo/cairo.h>' app/main.cpp '"render/page/page.hpp"' render/text/a.cpp '"render/ink/a.hpp"' \
    render/figures/a.cpp '"render/tables/a.hpp"' render/figures/a.cpp '"render/figures/b.hpp"' constructions/a.cpp '"engine/a.hpp"'
exit $failed
