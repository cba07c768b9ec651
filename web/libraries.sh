# The libraries that Kinegraph links, compiled for WebAssembly from Debian's source packages. To be sourced by web/build
# after cmake/setup.sh, with `cache` set to the folder that keeps what is fetched, compiled and installed.

sources=$cache/sources
prefix=$cache/prefix

# fetch_sources PACKAGE…: unpacks Debian's source packages, of the release that is installed. The list of sources is our
# own: the machine's is not changed, and needs no deb-src line.
fetch_sources() {
    mkdir -p "$sources" "$cache/apt/partial"
    release=$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")
    mirror=$(sed -n 's/^URIs: *//p; s/^deb \(\[.*\] \)\{0,1\}\([a-z]*:[^ ]*\) .* main.*/\2/p' \
        /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null | head -n 1)
    printf 'deb-src %s %s main\n' "${mirror:-http://deb.debian.org/debian}" "$release" >"$cache/apt/sources.list"
    apt_sources update -q && (cd "$sources" && apt_sources source -q --only-source "$@")
}
apt_sources() {
    apt-get -o "Dir::Etc::sourcelist=$cache/apt/sources.list" -o Dir::Etc::sourceparts=/dev/null \
        -o "Dir::State::lists=$cache/apt" -o APT::Sandbox::User=root "$@" </dev/null >&2
}

# logged NAME COMMAND…: runs a step quietly; shows the end of what it wrote if it fails.
logged() {
    log=$cache/$1.log
    shift
    "$@" >>"$log" 2>&1 </dev/null && return 0
    tail -n 20 "$log" >&2
    return 1
}

# configured_library NAME SOURCE [arguments of configure]: a library with a configure script, out of its source.
configured_library() {
    name=$1 source=$2
    shift 2
    rm -f "$cache/$name.log"
    mkdir -p "$cache/build/$name"
    (
        cd "$cache/build/$name" &&
            CC=emcc CXX=em++ CFLAGS=-O2 CXXFLAGS="-O2 -fwasm-exceptions" CC_FOR_BUILD=cc logged "$name" \
                emconfigure "$source/configure" --host=none --build="$(cc -dumpmachine)" --disable-shared \
                --prefix="$prefix" "$@" &&
            logged "$name" emmake make -j"$(nproc)" install SUBDIRS="${subdirectories-}" 
    )
}
