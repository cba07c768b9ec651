# Shared by ./kinegraph, tests/run and .ci/run: packages, configuration, build. POSIX sh, to be sourced with `top` set
# to the repository. All functions write to standard error only and do not read standard input.

say() { printf 'kinegraph: %s\n' "$*" >&2; }

as_root() {
    if [ "$(id -u)" = 0 ]; then "$@"; else sudo -- "$@"; fi
}

# packages SECTION…: the names under [SECTION] in cmake/packages.txt.
packages() {
    for section in "$@"; do
        sed -n "/^\[$section\]\$/,/^\[/{/^[a-z]/p;}" "$top/cmake/packages.txt"
    done
}

# missing_packages SECTION…: those that are not installed, by dpkg.
missing_packages() {
    wanted=$(packages "$@")
    # shellcheck disable=SC2086 # a list of words
    installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null | sed -n 's/^installed //p')
    for package in $wanted; do
        printf '%s\n' "$installed" | grep -qxF -- "$package" || printf '%s\n' "$package"
    done
}

apt_install() {
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends -o Dpkg::Use-Pty=0 "$@" </dev/null >&2
}

# install_packages SECTION…: installs missing packages by apt. The package lists are updated only if the first try
# fails.
install_packages() {
    if ! command -v dpkg-query >/dev/null; then
        say "no dpkg here: taking it that what cmake/packages.txt names is installed"
        return 0
    fi
    missing=$(missing_packages "$@")
    [ -n "$missing" ] || return 0
    if [ "$(id -u)" != 0 ] && ! command -v sudo >/dev/null; then
        say "as root, please: apt-get install" $missing
        return 1
    fi
    say "installing" $missing
    # shellcheck disable=SC2086
    apt_install $missing && return 0
    say "trying again with fresh package lists"
    # shellcheck disable=SC2086
    as_root apt-get update </dev/null >&2 && apt_install $missing
}

# install_modules FOLDER…: installs npm packages in the versions of FOLDER/package-lock.json.
install_modules() {
    for folder in "$@"; do
        modules=$top/$folder/node_modules
        cmp -s "$top/$folder/package-lock.json" "$modules/.installed" && continue
        command -v npm >/dev/null || apt_install npm || return 1
        npm ci --prefix "$top/$folder" --ignore-scripts --no-audit --no-fund </dev/null >&2 || return 1
        cp "$top/$folder/package-lock.json" "$modules/.installed"
    done
}

# configured DIRECTORY: true if a configuration was completed there (a failed one leaves a cache too).
configured() { [ -e "$1/build.ninja" ] || [ -e "$1/Makefile" ]; }

# configure DIRECTORY [cmake arguments]
configure() {
    directory=$1
    shift
    if [ ! -e "$directory/CMakeCache.txt" ] && command -v ninja >/dev/null; then set -- -G Ninja "$@"; fi
    cmake -S "$top" -B "$directory" "$@" </dev/null >&2
}

# build DIRECTORY [cmake --build arguments]: also writes a time stamp of its start, by which ./kinegraph finds newer
# sources.
build() {
    directory=$1
    shift
    : >"$directory/built.new" &&
        cmake --build "$directory" --parallel "$(nproc)" "$@" </dev/null >&2 &&
        mv "$directory/built.new" "$directory/built"
}
