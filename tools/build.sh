#!/usr/bin/env bash
# The module in .venv, and build/addons/illustrate, the add-on as installed with the module inside:
# for Python 3.11 and, when it is another, for that of Blender. build.sh tests: the C++ tests too.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

BUILD=$ROOT/build/native
ADDON=$ROOT/build/addons/illustrate
PATH=$VENV/bin:$PATH

# install_module FOLDER PREFIX: from a build into a folder of packages.
install_module() { cmake --install "$1" --component module --prefix "$2" >>"$1.log"; }

build_for_blender() {
    local blender version
    blender=$(find_blender) || return 0
    version=$(python_of_blender "$blender") || fail "$blender does not run as Blender does"
    [ "$version" = 3.11 ] && return
    compile_for_pythons "$version" && cp "$BUILD"/pythons/*.so "$ADDON/illustrate_native/"
}

"$ROOT/tools/setup_system.sh" build ${1:+test}
"$ROOT/tools/setup_python.sh"
mkdir -p "$ROOT/build"
exec 9>"$ROOT/build/build.lock"
flock 9

if [ "${1:-}" = tests ]; then
    configure "$BUILD" -DILLUSTRATE_TESTS=ON
    compile "$BUILD" _core illustrate_tests
else
    configure "$BUILD"
    compile "$BUILD" _core
fi

site_packages=$("$VENV/bin/python" -c 'import sysconfig; print(sysconfig.get_path("platlib"))')
rm -rf "$site_packages/illustrate_native" "$ADDON"
mkdir -p "$ADDON"
install_module "$BUILD" "$site_packages"
cp -r "$ROOT/addon/." "$ADDON"
install_module "$BUILD" "$ADDON"
build_for_blender
