#!/bin/sh
# Checks that the program and its late modules load no library of another module: one object file of the library that
# refers to more than its folder should would link all of it into a module.
#   modules_test.sh BUILD
set -u
failed=0

# only BINARY LIBRARY…: of the libraries that modules load late, it needs no others than these.
only() {
    binary=$1
    shift
    needed=$(readelf -d "$binary") || { failed=1; return; }
    for late in libcairo libharfbuzz libginac libzip; do
        case " $* " in *" $late "*) continue ;; esac
        if printf '%s\n' "$needed" | grep -q "NEEDED.*\[$late"; then
            printf '%s needs %s\n' "${binary##*/}" "$late"
            failed=1
        fi
    done
}

only "$1/kinegraph"
only "$1/kinegraph_cairo.so" libcairo libharfbuzz
only "$1/kinegraph_type.so" libharfbuzz
only "$1/kinegraph_ginac.so" libginac
only "$1/kinegraph_zip.so" libzip
exit $failed
