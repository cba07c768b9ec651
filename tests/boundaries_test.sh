#!/bin/sh
# Checks the dependencies of the folders: app → problems → render → engine, problems → constructions → engine,
# all → lang; python → include.
# Within each of them every folder includes only the folders that its `floor` line names. CGAL is included in one file
# of the engine, Eigen in the numeric check only, cairo in its back end only; only the table of pairs and the check may
# name kinds of joints.
#   boundaries_test.sh ROOT         prints every violation in the tree, one on each line; status 1 if there is one
#   boundaries_test.sh --self-test  tests that each kind of violation is found
set -u

# includes PATTERN FOLDER…: file:line:text of the matching includes among the files that `check` has listed.
includes() {
    pattern=$1
    shift
    within=$(printf '%s|' "$@")
    printf '%s\n' "$all" | grep -E "^(${within%|})/[^:]*:[0-9]+:[[:space:]]*#[[:space:]]*include[[:space:]]*$pattern"
}

breach() { sed "s|\$|   <- $1|"; }

# floor TOP FOLDER BELOW…: the includes in TOP/FOLDER of folders of TOP other than those listed.
floor() {
    top=$1 folder=$2
    floors="$floors $top/$folder"
    shift
    known=$(printf '|%s' "$@")
    shift
    includes "[\"<]$top/" "$top/$folder" | grep -vE "include[[:space:]]*[\"<]$top/(${known#|})/" |
        breach "in $top, $folder knows ${*:-itself alone}"
}

# Folders of the product that have no floor line.
unordered() {
    for folder in engine/* constructions/* render/* problems/* app/*; do
        [ -d "$folder" ] || continue
        case " $floors " in *" $folder "*) ;; *) printf '%s   <- has no place in the order of folders\n' "$folder" ;; esac
    done
    find engine constructions problems -maxdepth 1 -name '*.[ch]pp' 2>/dev/null | breach "source files stand in a folder of their subject"
}

check() {
    cd "$1" || return 2
    folders="lang engine constructions render problems app include python tests bench"
    floors=
    # shellcheck disable=SC2086 # lists of words
    all=$(find $folders -type f \( -name '*.cpp' -o -name '*.hpp' -o -name '*.h' \) 2>/dev/null | sort |
        xargs -r grep -nHE '^[[:space:]]*#[[:space:]]*include')
    # shellcheck disable=SC2086 # lists of words
    found=$(
        includes '["<](engine|constructions|render|problems|app|tests|bench)/' lang | breach "texts know no part of the product"
        includes '["<](constructions|render|problems|app|tests|bench)/' engine | breach "engine knows no other part"
        includes '["<](render|problems|app|tests|bench)/' constructions | breach "constructions knows the engine alone"
        includes '["<](problems|app|tests|bench)/' render | breach "render knows nothing of problems and app"
        includes '["<](app|tests|bench)/' problems | breach "problems know nothing of app"
        includes '["<]constructions/' render | breach "render needs no construction"
        floor engine number
        floor engine file number
        floor engine mechanism file number
        floor engine sentences mechanism file number
        floor engine drawing sentences mechanism file number
        floor engine board drawing sentences mechanism file number
        floor engine motion drawing sentences mechanism file number
        floor engine equations motion drawing sentences mechanism file number
        floor engine solution equations board motion drawing sentences mechanism file number
        floor engine results solution equations board motion drawing sentences mechanism file number
        floor engine reading results solution equations board motion drawing sentences mechanism file number
        floor engine check drawing sentences mechanism file number
        floor constructions kinematics
        floor constructions statics kinematics
        floor constructions verdicts
        floor constructions solving verdicts statics kinematics
        floor constructions positions solving verdicts
        floor constructions moving positions solving
        floor render ink
        floor render text ink
        floor render page ink text
        floor render backends ink text page
        floor render geogebra ink text page backends
        floor render scene ink text page
        floor render tables ink text page scene
        floor render equations ink text page scene tables
        floor render mechanism ink text page scene tables
        floor render figures ink text page scene tables equations mechanism
        floor render content ink text page scene tables equations mechanism figures
        floor render layout ink text page scene tables equations mechanism figures content
        floor render problems ink text page scene tables equations mechanism figures content
        floor render sheet ink text page scene tables equations mechanism figures content layout problems
        floor render live ink text page scene tables equations mechanism figures content layout problems sheet backends
        floor problems hertz
        floor problems reye
        floor problems impact
        floor problems point
        floor problems positions
        floor problems rotor
        floor app library
        floor app files
        floor app server files
        floor app late
        floor app workbench files
        floor app editor files
        floor app commands files server late workbench editor
        floor app modules late
        unordered
        includes '["<](engine|constructions|render|problems)/' app |
            grep -E '^app/(main\.cpp|(commands|editor|files|server|workbench)/[^:]*):' |
            breach "the command line uses the public face and nothing below it"
        includes '["<](tests|bench)/' app | breach "app knows nothing of tests"
        includes '["<](lang|engine|constructions|render|problems|app|tests|bench)/' python |
            breach "the module for Python uses the public face and nothing below it"
        includes '["<]python/' lang engine constructions render problems app include tests bench |
            breach "python/module is the module's own"
        includes '[<"](pybind11/|Python\.h)' $folders | grep -v '^python/module/' |
            breach "pybind11 is python/module's"
        includes '"' $folders | grep -vE 'include[[:space:]]*"(lang|engine|constructions|render|problems|app|kinegraph|python|tests|bench)/[a-z]' |
            breach "own headers are written from the root"
        includes '["<]kinegraph/' engine constructions render problems |
            breach "the public face stands above engine, constructions, render and problems"
        includes '["<]' include/kinegraph | grep -vE 'include[[:space:]]*<(kinegraph/[a-z]+\.hpp|tl/expected\.hpp|[a-z_]+)>' |
            breach "public headers include the standard library, tl/expected.hpp and each other"
        includes '[<"](unsupported/)?Eigen/' $folders | grep -vE '^(engine/check/[a-z_]*|problems/[a-z]*/check)\.[ch]pp:' |
            breach "Eigen is the numeric check's"
        includes '["<]engine/check/' engine | grep -vE '^engine/check/' | breach "the check is no source of results"
        includes '[<"](cairo/)?cairo' $folders | grep -v '^render/backends/cairo_backend\.cpp:' |
            breach "cairo is render/backends/cairo_backend.cpp's"
        includes '[<"]hb' $folders | grep -vE '^render/text/(typeface|font_files|subset)\.cpp:' |
            breach "HarfBuzz is that of typeface.cpp, font_files.cpp and subset.cpp in render/text"
        includes '<sys/socket\.h>' $folders | grep -v '^app/server/local_server\.cpp:' |
            breach "sockets are app/server/local_server.cpp's"
        includes '<dlfcn\.h>' $folders | grep -v '^app/late/back_ends\.cpp:' |
            breach "app/late/back_ends.cpp alone opens libraries late"
        includes '[<"](ginac|cln)/' $folders | grep -v '^engine/file/algebra_ginac\.cpp:' |
            breach "GiNaC is engine/file/algebra_ginac.cpp's"
        includes '[<"]zip\.h' $folders | grep -v '^render/backends/archive\.cpp:' |
            breach "libzip is render/backends/archive.cpp's"
        includes '[<"]CGAL/' $folders | grep -v '^engine/number/geometry\.cpp:' |
            breach "CGAL is engine/number/geometry.cpp's"
        grep -rn 'JointKind::' engine constructions render problems app 2>/dev/null |
            grep -vE '^engine/(mechanism/(pair|mechanism)|check/[a-z_]*)\.[ch]pp:' |
            breach "kinds of joint are the table of pairs' and the check's"
        grep -rnE '(data_figure|(figure|drawn|wanted)[a-z_]*(\.|->)(id|name)) *[!=]= *"' render problems app 2>/dev/null |
            breach "a figure is told from another by its FigureId or its traits, not by text"
        grep -rnE 'std::(a?sin|a?cos|a?tan|atan2|exp|log|log10|pow|sinh|cosh|tanh|cbrt|hypot)\(' \
            engine constructions render problems app --include='*.[ch]pp' 2>/dev/null |
            grep -v '^engine/number/functions\.cpp:' |
            breach "elementary functions are those of engine/number/functions.hpp, the same on every machine"
        # A point and its key are many other things, too.
        kinds=$(ls problems 2>/dev/null | grep -vx point | paste -sd '|')
        grep -rnE "\"(${kinds:-none})\"" engine constructions render --include='*.[ch]pp' 2>/dev/null |
            breach "kinds of problems are rows of app/library/problem_kinds.cpp"
    )
    [ -z "$found" ] && return 0
    printf '%s\n' "$found"
    return 1
}

# seen TEXT FILE INCLUDE: a tree in which the file has this include is refused with TEXT. All are checked together, by
# told, since looking through a tree takes a third of a second.
seen() {
    mkdir -p "$tree/${2%/*}"
    printf '#include %s\n' "$3" >>"$tree/$2"
    printf '%s\t%s\n' "$2" "$1" >>"$wanted"
}
# told: whether each line of `seen` was refused, at its file or at its folder.
told() {
    said=$(check "$tree")
    while IFS="$tab" read -r file text; do
        printf '%s\n' "$said" | grep -F -- "$text" | grep -qE "^($file:|$file |${file%/*} )" && continue
        printf '%s was not refused with "%s"\n' "$file" "$text"
        failed=1
    done <"$wanted"
}
# accepted FILE INCLUDE [FILE INCLUDE]…: a tree with these includes is not refused.
accepted() {
    allowed=$(mktemp -d)
    while [ $# -gt 0 ]; do
        mkdir -p "$allowed/${1%/*}"
        printf '#include %s\n' "$2" >>"$allowed/$1"
        shift 2
    done
    said=$(check "$allowed")
    rm -r "$allowed"
    [ -z "$said" ] && return 0
    printf 'was refused: %s\n' "$said"
    failed=1
}

if [ "$1" != --self-test ]; then
    check "$1"
    exit
fi
tree=$(mktemp -d) wanted=$(mktemp) tab=$(printf '\t')
failed=0
seen "texts know" lang/words.cpp '"engine/number/b.hpp"'
seen "engine knows" engine/board/a.cpp '"constructions/b.hpp"'
seen "engine knows" engine/board/a.hpp '"render/b.hpp"'
seen "engine alone" constructions/statics/a.hpp '"render/b.hpp"'
seen "nothing of problems and app" render/page/a.cpp '"app/b.hpp"'
seen "nothing of problems and app" render/page/a.cpp '"problems/hertz/hertz.hpp"'
seen "engine knows" engine/reading/a.cpp '"problems/hertz/hertz.hpp"'
seen "problems know nothing of app" problems/hertz/a.cpp '"app/library/b.hpp"'
seen "hertz knows itself alone" problems/hertz/a.cpp '"problems/reye/reye.hpp"'
seen "needs no construction" render/page/a.cpp '"constructions/b.hpp"'
seen "file knows number" engine/file/a.hpp '"engine/mechanism/b.hpp"'
seen "board knows" engine/board/a.cpp '"engine/solution/b.hpp"'
seen "statics knows kinematics" constructions/statics/a.cpp '"constructions/solving/b.hpp"'
seen "ink knows itself alone" render/ink/a.hpp '"render/text/b.hpp"'
seen "page knows ink text" render/page/a.hpp '"render/figures/b.hpp"'
seen "figures knows" render/figures/a.cpp '"render/sheet/b.hpp"'
seen "content knows" render/content/a.cpp '"render/layout/b.hpp"'
seen "nothing below it" app/main.cpp '"render/page/page.hpp"'
seen "nothing below it" app/commands/a.cpp '"engine/board/b.hpp"'
seen "nothing below it" app/workbench/a.cpp '"engine/board/b.hpp"'
seen "nothing below it" app/editor/a.cpp '"engine/file/b.hpp"'
seen "workbench knows" app/workbench/a.cpp '"app/server/b.hpp"'
seen "for Python uses the public face" python/module/a.cpp '"engine/board/b.hpp"'
seen "module's own" app/main.cpp '"python/module/bindings.hpp"'
seen "pybind11 is" app/library/a.cpp '<pybind11/pybind11.h>'
seen "files knows" app/files/a.cpp '"app/commands/b.hpp"'
seen "no place in the order" engine/elsewhere/a.cpp '<vector>'
seen "folder of their subject" engine/a.cpp '<vector>'
seen "from the root" render/page/a.cpp '"../app/b.hpp"'
seen "from the root" engine/board/a.cpp '"b.hpp"'
seen "numeric check's" engine/board/board.cpp '<Eigen/Dense>'
seen "numeric check's" problems/hertz/solving.cpp '<Eigen/Dense>'
seen "numeric check's" tests/a_test.cpp '<Eigen/Dense>'
seen "source of results" engine/results/a.cpp '"engine/check/b.hpp"'
seen "cairo_backend.cpp's" render/text/text.cpp '<cairo/cairo.h>'
seen "cairo_backend.cpp's" app/main.cpp '<cairo-pdf.h>'
seen "opens libraries late" engine/file/algebra.cpp '<dlfcn.h>'
seen "algebra_ginac.cpp's" engine/file/expression.cpp '<ginac/ginac.h>'
seen "archive.cpp's" app/modules/zip.cpp '<zip.h>'
seen "HarfBuzz is" render/text/text.cpp '<hb.h>'
seen "geometry.cpp's" constructions/statics/a.cpp '<CGAL/Point_2.h>'
seen "geometry.cpp's" engine/number/exact.cpp '<CGAL/a.h>'
seen "public face stands above" engine/board/a.cpp '"kinegraph/solution.hpp"'
seen "public headers include" include/kinegraph/a.hpp '"engine/number/exact.hpp"'
seen "kinds of problems" render/sheet/a.cpp '"hertz"'
seen "not by text" render/sheet/a.cpp 'figure.data_figure == "forces"'
seen "not by text" render/tables/a.cpp 'figure.id != "cremona"'
seen "the same on every machine" render/page/a.cpp 'const double c = std::cos(angle);'
seen "kinds of joint" constructions/statics/a.cpp 'JointKind::gear'
told
accepted engine/mechanism/pair.cpp 'JointKind::gear' engine/check/check_forces.cpp 'JointKind::weld' \
    tests/a_test.cpp 'JointKind::gear'
accepted engine/number/geometry.cpp '<CGAL/a.h>' engine/number/geometry.cpp '<CGAL/b.h>' \
    engine/check/check.cpp '<Eigen/QR>' problems/hertz/check.cpp '<Eigen/Dense>' problems/hertz/a.cpp '"render/page/a.hpp"' engine/check/check_forces.cpp '"engine/check/a.hpp"' \
    render/backends/cairo_backend.cpp '<cairo/cairo.h>' app/library/a.cpp '"render/page/page.hpp"' app/main.cpp '"kinegraph/mechanism.hpp"' \
    render/text/a.cpp '"render/ink/a.hpp"' render/figures/a.cpp '"render/tables/a.hpp"' \
    constructions/solving/a.cpp '"engine/check/a.hpp"' constructions/statics/forces/a.cpp '"constructions/kinematics/a.hpp"'
rm -r "$tree" "$wanted"
exit $failed
