# The libraries that Kinegraph links, compiled for WebAssembly from Debian's source packages. POSIX sh, to be sourced by
# web/build after cmake/setup.sh, with `cache` set to the folder that keeps what is fetched, compiled and installed.

sources=$cache/sources
objects=$cache/objects
prefix=$cache/prefix
system=/usr/share/emscripten/cache/sysroot
debian_sources="gmp mpfr4 nettle harfbuzz pugixml"

# Debian's clang with the system libraries of Debian's emscripten. emcc would call the same compiler, but takes a second
# for each file to start.
compile="--target=wasm32-unknown-emscripten --sysroot=$system -O2 -ffunction-sections -fdata-sections"
compile_cxx="$compile -D_LIBCPP_ABI_VERSION=2 -Xclang -iwithsysroot/include/compat -fno-threadsafe-statics \
-mllvm -combiner-global-alias-analysis=false -mllvm -disable-lsr"

# fetch_sources PACKAGE…: unpacks Debian's source packages, of the release that is installed. The list of sources is our
# own: the machine's is not changed, and needs no deb-src line.
fetch_sources() {
    mkdir -p "$sources" "$cache/apt/partial"
    release=$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")
    mirror=$(sed -n 's/^URIs: *//p; s/^deb \(\[.*\] \)\{0,1\}\([a-z]*:[^ ]*\) .* main.*/\2/p' \
        /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null | head -n 1)
    [ -n "$mirror" ] || { say "apt's sources name no mirror of Debian, from which source packages could come"; return 1; }
    printf 'deb-src %s %s main\n' "$mirror" "$release" >"$cache/debian.list" # not in apt's folder, which apt clears
    apt_sources update -q && (cd "$sources" && apt_sources source -q "$@")
}
apt_sources() {
    apt-get -o "Dir::Etc::sourcelist=$cache/debian.list" -o Dir::Etc::sourceparts=/dev/null \
        -o "Dir::State::lists=$cache/apt" -o APT::Sandbox::User=root "$@" </dev/null >&2
}
# source_of PACKAGE: the folder it was unpacked into.
source_of() { find "$sources/" -maxdepth 1 -type d -name "$1-[0-9]*"; }

# archive_c LIBRARY [options]: compiles the C files named on standard input, a line each, into a library. The name of a
# file is also a definition, by which GMP makes several functions of one file.
archive_c() {
    library=$1
    shift
    rm -rf "${objects:?}/$library"
    mkdir -p "$objects/$library"
    # shellcheck disable=SC2016,SC2086 # the inner shell's arguments; a list of words
    OBJECTS=$objects/$library xargs -P "$(nproc)" -n 1 sh -c '
        for file; do :; done
        clang-14 -w $0 "-DOPERATION_$(basename "$file" .c)" -c "$file" -o "$OBJECTS/$(echo "$file" | tr / _).o"' \
        "$compile $*" || return 1
    rm -f "$prefix/lib/lib$library.a"
    llvm-ar-14 rcs "$prefix/lib/lib$library.a" "$objects/$library"/*.o
}

# GMP by its configure script, which finds out little here, and files in C only. Limbs of 64 bits, as on the machines
# that the native program runs on: WebAssembly multiplies them as fast, and long is not a limb. configure looks for the
# format of doubles in the code of an object file, and does not find it in WebAssembly's.
build_gmp() {
    gmp=$(source_of gmp)
    mkdir -p "$objects/gmp-tables" "$gmp/doc"
    touch "$gmp/doc/Makefile.in" # which Debian leaves out
    sed -i 's/^# Long long limb setup for gmp.h.$/limb_chosen=longlong/' "$gmp/configure"
    (
        cd "$objects/gmp-tables" &&
            printf '#!/bin/sh\nexec clang-14 %s -nostdlib -Wl,--no-entry -Qunused-arguments "$@"\n' "$compile" >cc &&
            chmod +x cc &&
            logged gmp env "gmp_cv_c_double_format=IEEE little endian" "$gmp/configure" CC="$PWD/cc" \
                CC_FOR_BUILD=cc AR=llvm-ar-14 NM=llvm-nm-14 RANLIB=llvm-ranlib-14 \
                --host=none --build="$(cc -dumpmachine)" --disable-assembly --disable-shared &&
            logged gmp make fac_table.h fib_table.h mpn/fib_table.c mp_bases.h mpn/mp_bases.c \
                trialdivtab.h mpn/jacobitab.h mpn/perfsqr.h &&
            cp gmp.h "$gmp/gmpxx.h" "$prefix/include" &&
            { ls mpn/*.c && ls "$gmp"/mp[zqf]/*.c && (cd "$gmp" && for name in assert compat errno extract-dbl invalid \
                memory mp_bpl mp_clz_tab mp_dv_tab mp_minv_tab mp_get_fns mp_set_fns nextprime primesieve tal-reent \
                version; do echo "$gmp/$name.c"; done); } |
            archive_c gmp -DHAVE_CONFIG_H -D__GMP_WITHIN_GMP -I. "-I$gmp" "-I$gmp/mpn"
    )
}

# MPFR without its configure script, whose answers are known: a C compiler of today, doubles of IEEE, one thread.
build_mpfr() {
    mpfr=$(source_of mpfr4)
    cp "$mpfr/src/mpfr.h" "$prefix/include"
    cp "$mpfr/src/mparam_h.in" "$mpfr/src/mparam.h"
    find "$mpfr/src" -maxdepth 1 -name '*.c' ! -name '*_extracted.c' ! -name '*_generic.c' ! -name jyn_asympt.c \
        ! -name speed.c ! -name tuneup.c ! -name '*printf.c' |
        archive_c mpfr -D__MPFR_WITHIN_MPFR -DHAVE_STDARG -DHAVE_STDINT_H -DHAVE_INTTYPES_H -DHAVE_INTMAX_T \
            -DHAVE_LITTLE_ENDIAN -DHAVE_DOUBLE_IEEE_LITTLE_ENDIAN "-I$prefix/include" "-I$mpfr/src"
}

# Of nettle SHA-256 and base64 only.
build_nettle() {
    nettle=$(source_of nettle)
    mkdir -p "$prefix/include/nettle"
    cp "$nettle/base64.h" "$nettle/sha2.h" "$nettle/nettle-types.h" "$prefix/include/nettle"
    for name in sha256 sha256-compress write-be32 base64-encode; do echo "$nettle/$name.c"; done |
        archive_c nettle "-I$nettle"
}

# archive_cxx LIBRARY FILE [options]: a library of one file of C++.
archive_cxx() {
    library=$1 file=$2
    shift 2
    # shellcheck disable=SC2086
    clang++-14 -w $compile_cxx -std=c++17 "$@" -c "$file" -o "$objects/$library.o" &&
        rm -f "$prefix/lib/lib$library.a" && llvm-ar-14 rcs "$prefix/lib/lib$library.a" "$objects/$library.o"
}
# HarfBuzz without what STIX and the program's calls of it do not need: it is a seventh of the code otherwise.
build_harfbuzz() {
    harfbuzz=$(source_of harfbuzz)
    left_out="AAT BITMAP BUFFER_MESSAGE BUFFER_SERIALIZE BUFFER_VERIFY COLOR ERRNO FACE_COLLECT_UNICODES GETENV \
        LANGUAGE_PRIVATE_SUBTAG LAYOUT_COLLECT_GLYPHS LAYOUT_FEATURE_PARAMS META METRICS MMAP MT OPEN \
        OT_FONT_GLYPH_NAMES OT_LAYOUT_LOOKUP_CACHE SETLOCALE STYLE VAR"
    # shellcheck disable=SC2046,SC2086
    cp "$harfbuzz"/src/hb*.h "$prefix/include" &&
        archive_cxx harfbuzz "$harfbuzz/src/harfbuzz-subset.cc" -Os -fno-exceptions -fno-rtti -DHB_NDEBUG \
            -DHB_OPTIMIZE_SIZE $(printf -- '-DHB_NO_%s ' $left_out)
}
build_pugixml() {
    pugixml=$(source_of pugixml)
    cp "$pugixml"/src/*.hpp "$prefix/include" && archive_cxx pugixml "$pugixml/src/pugixml.cpp" -fwasm-exceptions
}

# logged NAME COMMAND…: runs a step quietly; shows the end of what it wrote if it fails.
logged() {
    log=$cache/$1.log
    shift
    "$@" >>"$log" 2>&1 </dev/null && return 0
    tail -n 20 "$log" >&2
    return 1
}

# Headers that are the same for every machine are taken from Debian's packages, each by a link: /usr/include as a whole
# has the C library of this machine.
link_headers() {
    for name in CGAL boost eigen3 fast_float fmt nlohmann tl; do
        ln -sfn "/usr/include/$name" "$prefix/include/$name"
    done
}

# build_each LIBRARY…: those that were not compiled before.
build_each() {
    for each in "$@"; do
        [ ! -e "$prefix/lib/lib$each.a" ] || continue
        say "compiling $each"
        "build_$each" || return 1
    done
}

# build_libraries: all of the above, each once. HarfBuzz is one large file: the others are compiled beside it.
build_libraries() {
    mkdir -p "$objects" "$prefix/include" "$prefix/lib"
    # shellcheck disable=SC2086
    [ -e "$sources/fetched" ] || { fetch_sources $debian_sources && touch "$sources/fetched"; } || return 1
    link_headers
    build_each harfbuzz pugixml &
    large=$!
    build_each gmp mpfr nettle || { wait "$large"; return 1; }
    wait "$large"
}
