#!/usr/bin/env bash
# OpenSubdiv (sdc, vtr, far, bfr), NLopt and musl's mathematical functions as static libraries with
# hidden symbols.
#
# They are built once, and kept in the cache. Prints the folder that holds include/, lib/ and
# licenses/ as its last line.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

RECIPE=("$ROOT/tools/setup_static_libraries.sh" "$ROOT/tools/setup_library_sources.sh"
    "$ROOT/tools/static_libraries/CMakeLists.txt" "$ROOT"/tools/static_libraries/math/CMakeLists.txt
    "$ROOT"/tools/static_libraries/math/include/*.h "$ROOT"/tools/patches/*.patch)
PREFIX=$CACHE/static-$(recipe_hash "${RECIPE[@]}")
CMAKE=${CMAKE:-$VENV/bin/cmake}

build() {
    "$CMAKE" -G "Unix Makefiles" -DCMAKE_BUILD_TYPE=Release \
        "-DCMAKE_INSTALL_PREFIX=$install" -DCMAKE_INSTALL_LIBDIR=lib \
        -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DBUILD_SHARED_LIBS=OFF \
        "-DCMAKE_C_FLAGS_RELEASE=-O2 -DNDEBUG -ffp-contract=off" \
        "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG -ffp-contract=off" \
        -DCMAKE_C_VISIBILITY_PRESET=hidden -DCMAKE_CXX_VISIBILITY_PRESET=hidden \
        -DCMAKE_VISIBILITY_INLINES_HIDDEN=ON -S "$1" -B "$2" "${@:3}" -Wno-dev -Wno-deprecated
    "$CMAKE" --build "$2" --parallel "$JOBS"
    "$CMAKE" --install "$2"
}

build_libraries() {
    local work=$1 install=$1/install sources=$2
    build "$ROOT/tools/static_libraries" "$work/build-opensubdiv" \
        "-DOPENSUBDIV_SOURCE=$sources/opensubdiv"
    build "$ROOT/tools/static_libraries/math" "$work/build-math" "-DMUSL_SOURCE=$sources/musl"
    # NLopt's generator scripts ask for an old CMake policy, while building too.
    export CMAKE_POLICY_VERSION_MINIMUM=3.5
    build "$sources/nlopt" "$work/build-nlopt" -DNLOPT_PYTHON=OFF -DNLOPT_OCTAVE=OFF \
        -DNLOPT_MATLAB=OFF -DNLOPT_GUILE=OFF -DNLOPT_SWIG=OFF -DNLOPT_TESTS=OFF
    cp -r "$sources/licenses" "$install/"
}

main() {
    [ -d "$PREFIX" ] && return
    mkdir -p "$CACHE"
    exec 9>"$CACHE/static.lock"
    flock 9
    [ -d "$PREFIX" ] && return
    local work sources
    sources=$("$ROOT/tools/setup_library_sources.sh")
    work=$(mktemp -d "$CACHE/static-build.XXXXXX")
    trap "rm -rf '$work'" EXIT
    say "building OpenSubdiv, NLopt and musl's mathematical functions (once)"
    build_libraries "$work" "$sources" >"$CACHE/static-build.log" 2>&1 ||
        fail "the build failed: see $CACHE/static-build.log"
    mv "$work/install" "$PREFIX"
}

main >&2
printf '%s\n' "$PREFIX"
