# Sourced by the other scripts: where things are, and the few words they share.
set -euo pipefail

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
VENV=$ROOT/.venv
CACHE=${ILLUSTRATE_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/illustrate}
JOBS=${JOBS:-2}

say() { printf '%s\n' "illustrate: $*"; }
fail() {
    printf '%s\n' "illustrate: error: $*" >&2
    exit 1
}

# recipe_hash FILE...: names what a cached result depends on, the compiler included.
recipe_hash() {
    { cat "$@" && "${CXX:-g++}" -dumpversion && "${CXX:-g++}" -dumpmachine; } |
        sha256sum | cut -c1-16
}

# pythons VERSION: programs that may be that Python, those on the path first, then pyenv's.
pythons() {
    type -ap "python$1" python3 || true
    ls -d "${PYENV_ROOT:-$HOME/.pyenv}/versions/$1".*/bin/python /usr/bin/python"$1" 2>/dev/null || true
}

# find_python [VERSION]: the first of them, 3.11 unless said, that can make environments and build
# modules.
find_python() {
    local version=${1:-3.11} candidate
    for candidate in $(pythons "$version"); do
        if "$candidate" - "$version" 2>/dev/null <<'CHECK'; then
import ensurepip, os, sys, sysconfig, venv
header = os.path.join(sysconfig.get_paths()["include"], "Python.h")
sys.exit("%d.%d" % sys.version_info[:2] != sys.argv[1] or not os.path.exists(header))
CHECK
            printf '%s\n' "$candidate"
            return
        fi
    done
    return 1
}

# suite_of_python VERSION: the Debian that has this Python, newer than that of Debian 12.
suite_of_python() {
    case $1 in
        3.13) echo trixie ;;
        3.14) echo sid ;;
        *) return 1 ;;
    esac
}

# debian_mirror: where this machine's own package lists say that Debian's packages are.
debian_mirror() {
    sed -n 's/^URIs:[[:space:]]*\([^[:space:]]*\).*/\1/p' \
        /etc/apt/sources.list.d/debian.sources 2>/dev/null | sed -n '1{p;q}'
    sed -n 's/^deb[[:space:]]\+\(\[[^]]*\][[:space:]]*\)\?\([^[:space:]]*\).*/\2/p' \
        /etc/apt/sources.list 2>/dev/null | sed -n '1{p;q}'
}

# configure FOLDER [CMAKE OPTION...]: for the Python of .venv, unless it is for another system.
configure() {
    cmake -G Ninja -S "$ROOT" -B "$1" "-DPython_EXECUTABLE=$VENV/bin/python" \
        "-Dpybind11_DIR=$("$VENV/bin/python" -m pybind11 --cmakedir)" "${@:2}" >"$1.log" ||
        { cat "$1.log" && fail "CMake could not configure the build"; } >&2
}

# compile FOLDER TARGET...
compile() { cmake --build "$1" --parallel "$JOBS" --target "${@:2}"; }

# build_unoptimised TARGET...: in build/unoptimised. Link-time optimisation shows the compiler all
# files at once: it refuses types of one name that differ (the one-definition rule).
build_unoptimised() {
    configure "$ROOT/build/unoptimised" -DCMAKE_BUILD_TYPE=Unoptimised \
        -DILLUSTRATE_TESTS=ON -DCMAKE_INTERPROCEDURAL_OPTIMIZATION=ON \
        "-DCMAKE_CXX_FLAGS=-Werror=odr -Werror=lto-type-mismatch" &&
        compile "$ROOT/build/unoptimised" "$@"
}

# compile_for_pythons VERSION...: the module for these Pythons, in build/native/pythons.
compile_for_pythons() {
    local version folders list=
    for version in "$@"; do
        folders=$("$ROOT/tools/setup_headers.sh" "$version") || return
        list="$list${list:+;}$version=$folders"
    done
    rm -rf "$ROOT/build/native/pythons"
    configure "$ROOT/build/native" "-DILLUSTRATE_PYTHON_HEADERS=$list"
    compile "$ROOT/build/native" "${@/#/_core_}"
}

# find_blender: $BLENDER, else the one on the path.
find_blender() { command -v "${BLENDER:-blender}"; }

# python_of_blender PROGRAM: such as 3.11
python_of_blender() {
    "$1" -b --factory-startup --python-expr \
        'import sys; print("Python %d.%d of Blender" % sys.version_info[:2])' 2>/dev/null |
        sed -n 's/^Python \([0-9.]*\) of Blender$/\1/p'
}
