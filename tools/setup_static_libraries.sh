#!/usr/bin/env bash
# OpenSubdiv (sdc, vtr, far, bfr) and NLopt as static libraries with hidden symbols.
#
# They are built once from the sources that Debian publishes, held to checksums, and kept in the
# cache. Prints the folder that holds include/, lib/ and licenses/ as its last line.
# ILLUSTRATE_SOURCES may name a folder that already holds the two archives.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

OPENSUBDIV=opensubdiv_3.5.0.orig.tar.xz
OPENSUBDIV_SHA256=8bc452ad9934d69bd2b03662e9d86a3d014d95445dc599013e523e577ae90693
NLOPT=nlopt_2.7.1.orig.tar.gz
NLOPT_SHA256=db88232fa5cef0ff6e39943fc63ab6074208831dc0031cf1545f6ecd31ae2a1a
PATCHES=("$ROOT"/tools/patches/*.patch)
RECIPE=("$ROOT/tools/setup_static_libraries.sh" "$ROOT/tools/static_libraries/CMakeLists.txt"
    "${PATCHES[@]}")

SOURCES=${ILLUSTRATE_SOURCES:-$CACHE/sources}
PREFIX=$CACHE/static-$(recipe_hash "${RECIPE[@]}")
CMAKE=${CMAKE:-$VENV/bin/cmake}

has_checksum() { [ -f "$1" ] && echo "$2  $1" | sha256sum --check --status; }

have_sources() {
    has_checksum "$SOURCES/$OPENSUBDIV" "$OPENSUBDIV_SHA256" &&
        has_checksum "$SOURCES/$NLOPT" "$NLOPT_SHA256"
}

# The machine's own package sources, asked for source packages: a private copy of its list, so
# that its configuration stays as it is.
private_apt() {
    local parts=$1/parts lists=$1/lists
    mkdir -p "$parts" "$lists/partial"
    for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ -f "$list" ] && sed 's/^deb\([[:space:]]\)/deb-src\1/' "$list" >"$parts/${list##*/}.list"
    done
    for list in /etc/apt/sources.list.d/*.sources; do
        [ -f "$list" ] && sed 's/^Types:.*/Types: deb-src/' "$list" >"$parts/${list##*/}"
    done
    APT=(apt-get -qq -o APT::Sandbox::User= -o Dir::Etc::sourcelist=/dev/null
        -o "Dir::Etc::sourceparts=$parts" -o "Dir::State::lists=$lists"
        -o Dir::Cache::srcpkgcache= -o Dir::Cache::pkgcache=)
}

fetch_sources() {
    local work=$1/apt
    say "fetching the sources of OpenSubdiv and NLopt"
    private_apt "$work"
    (cd "$work" && "${APT[@]}" update && "${APT[@]}" source --download-only opensubdiv nlopt) >&2 ||
        fail "cannot fetch the sources. Put $OPENSUBDIV and $NLOPT into a folder and set" \
            "ILLUSTRATE_SOURCES to it, or configure with -DILLUSTRATE_SYSTEM_LIBRARIES=ON."
    mkdir -p "$SOURCES"
    for archive in "$OPENSUBDIV" "$NLOPT"; do
        [ -f "$work/$archive" ] || fail "this Debian does not publish $archive (Debian 12 does)"
        mv "$work/$archive" "$SOURCES/"
    done
    have_sources || fail "a source archive in $SOURCES does not have the expected checksum"
}

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
    local work=$1 install=$1/install
    mkdir -p "$work/opensubdiv" "$work/nlopt"
    tar -xf "$SOURCES/$OPENSUBDIV" -C "$work/opensubdiv" --strip-components=1
    tar -xf "$SOURCES/$NLOPT" -C "$work/nlopt" --strip-components=1
    for patch in "${PATCHES[@]}"; do
        patch --directory="$work/opensubdiv" --strip=1 --fuzz=0 <"$patch"
    done
    build "$ROOT/tools/static_libraries" "$work/build-opensubdiv" \
        "-DOPENSUBDIV_SOURCE=$work/opensubdiv"
    # NLopt's generator scripts ask for an old CMake policy, while building too.
    export CMAKE_POLICY_VERSION_MINIMUM=3.5
    build "$work/nlopt" "$work/build-nlopt" -DNLOPT_PYTHON=OFF -DNLOPT_OCTAVE=OFF \
        -DNLOPT_MATLAB=OFF -DNLOPT_GUILE=OFF -DNLOPT_SWIG=OFF -DNLOPT_TESTS=OFF
    mkdir -p "$install/licenses"
    cp "$work/opensubdiv/LICENSE.txt" "$install/licenses/opensubdiv.txt"
    cp "$work/opensubdiv/NOTICE.txt" "$install/licenses/opensubdiv-notice.txt"
    cp "$work/nlopt/COPYING" "$install/licenses/nlopt.txt"
    cp "$work/nlopt/src/algs/luksan/COPYRIGHT" "$install/licenses/nlopt-luksan.txt"
}

main() {
    [ -d "$PREFIX" ] && return
    mkdir -p "$CACHE"
    exec 9>"$CACHE/static.lock"
    flock 9
    [ -d "$PREFIX" ] && return
    local work
    work=$(mktemp -d "$CACHE/static-build.XXXXXX")
    trap "rm -rf '$work'" EXIT
    have_sources || fetch_sources "$work"
    say "building OpenSubdiv and NLopt (once)"
    build_libraries "$work" >"$CACHE/static-build.log" 2>&1 ||
        fail "the build failed: see $CACHE/static-build.log"
    mv "$work/install" "$PREFIX"
}

main >&2
printf '%s\n' "$PREFIX"
