#!/usr/bin/env bash
# The module in .venv, and build/addons/illustrate, the add-on as installed with the module inside:
# for Python 3.11 and, when it is another, for that of Blender. build.sh tests: the C++ tests too.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

ADDON=$ROOT/build/addons/illustrate
PATH=$VENV/bin:$PATH

# configure FOLDER PYTHON [CMAKE OPTION...]
configure() {
    cmake -G Ninja -S "$ROOT" -B "$1" "-DPython_EXECUTABLE=$2" \
        "-Dpybind11_DIR=$("$VENV/bin/python" -m pybind11 --cmakedir)" "${@:3}" >"$1.log" ||
        { cat "$1.log" && fail "CMake could not configure the build"; } >&2
}

# compile FOLDER TARGET...
compile() { cmake --build "$1" --parallel "$JOBS" --target "${@:2}"; }

# install_module FOLDER PREFIX: from a build into a folder of packages.
install_module() { cmake --install "$1" --component module --prefix "$2" >>"$1.log"; }

# python_with_headers VERSION
python_with_headers() {
    local python
    python=$(command -v "python$1") && "$python" -c 'import os, sys, sysconfig
sys.exit(not os.path.exists(os.path.join(sysconfig.get_paths()["include"], "Python.h")))' &&
        printf '%s\n' "$python"
}

build_for_blender() {
    local blender version python
    blender=$(find_blender) || return 0
    version=$(python_of_blender "$blender") || fail "$blender does not run as Blender does"
    [ "$version" = 3.11 ] && return
    if ! python=$(python_with_headers "$version"); then
        say "$blender runs Python ${version:-?}: install python$version with its headers" \
            "(python$version-dev) to build the module for it"
        return
    fi
    configure "$ROOT/build/native-$version" "$python"
    compile "$ROOT/build/native-$version" _core
    install_module "$ROOT/build/native-$version" "$ADDON"
}

"$ROOT/tools/setup_system.sh" build
"$ROOT/tools/setup_python.sh"
mkdir -p "$ROOT/build"
exec 9>"$ROOT/build/build.lock"
flock 9

if [ "${1:-}" = tests ]; then
    configure "$ROOT/build/native" "$VENV/bin/python" -DILLUSTRATE_TESTS=ON
    compile "$ROOT/build/native" _core illustrate_tests
else
    configure "$ROOT/build/native" "$VENV/bin/python"
    compile "$ROOT/build/native" _core
fi

site_packages=$("$VENV/bin/python" -c 'import sysconfig; print(sysconfig.get_path("platlib"))')
rm -rf "$site_packages/illustrate_native" "$ADDON"
mkdir -p "$ADDON"
install_module "$ROOT/build/native" "$site_packages"
cp -r "$ROOT/addon/." "$ADDON"
install_module "$ROOT/build/native" "$ADDON"
build_for_blender
