#!/usr/bin/env bash
# The sources of OpenSubdiv, patched, of NLopt, and of musl's mathematical functions, from the
# archives that Debian publishes, held to checksums. Prints the folder that holds opensubdiv/, nlopt/,
# musl/ and licenses/ as its last line.
# ILLUSTRATE_SOURCES may name a folder that already holds the three archives.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/debian_packages.sh"

OPENSUBDIV=opensubdiv_3.5.0.orig.tar.xz
OPENSUBDIV_SHA256=8bc452ad9934d69bd2b03662e9d86a3d014d95445dc599013e523e577ae90693
NLOPT=nlopt_2.7.1.orig.tar.gz
NLOPT_SHA256=db88232fa5cef0ff6e39943fc63ab6074208831dc0031cf1545f6ecd31ae2a1a
MUSL=musl_1.2.3.orig.tar.gz
MUSL_SHA256=7d5b0b6062521e4627e099e4c9dc8248d32a30285e959b7eecaa780cf8cfd4a4
PATCHES=("$ROOT"/tools/patches/*.patch)

SOURCES=${ILLUSTRATE_SOURCES:-$CACHE/sources}
UNPACKED=$CACHE/library-sources-$(cat "${BASH_SOURCE[0]}" "${PATCHES[@]}" | sha256sum | cut -c1-16)

have_archives() {
    has_checksum "$SOURCES/$OPENSUBDIV" "$OPENSUBDIV_SHA256" &&
        has_checksum "$SOURCES/$NLOPT" "$NLOPT_SHA256" &&
        has_checksum "$SOURCES/$MUSL" "$MUSL_SHA256"
}

fetch_archives() {
    local work=$1/apt
    say "fetching the sources of OpenSubdiv, NLopt and musl"
    own_package_sources "$work"
    (cd "$work" && "${APT[@]}" update &&
        "${APT[@]}" source --download-only opensubdiv nlopt musl) >&2 ||
        fail "cannot fetch the sources. Put $OPENSUBDIV, $NLOPT and $MUSL into a folder and set" \
            "ILLUSTRATE_SOURCES to it, or configure with -DILLUSTRATE_SYSTEM_LIBRARIES=ON."
    mkdir -p "$SOURCES"
    for archive in "$OPENSUBDIV" "$NLOPT" "$MUSL"; do
        [ -f "$work/$archive" ] || fail "this Debian does not publish $archive (Debian 12 does)"
        mv "$work/$archive" "$SOURCES/"
    done
    have_archives || fail "a source archive in $SOURCES does not have the expected checksum"
}

# unpack FOLDER: their sources, patched, and the licences of what the module takes from them.
unpack() {
    local patch folder=${MUSL%.orig.tar.gz}
    folder=${folder/_/-}
    mkdir -p "$1/opensubdiv" "$1/nlopt" "$1/musl" "$1/licenses"
    tar -xf "$SOURCES/$OPENSUBDIV" -C "$1/opensubdiv" --strip-components=1
    tar -xf "$SOURCES/$NLOPT" -C "$1/nlopt" --strip-components=1
    tar -xf "$SOURCES/$MUSL" -C "$1/musl" --strip-components=1 \
        "$folder/src/math" "$folder/src/complex/cabs.c" "$folder/src/internal/libm.h" \
        "$folder/src/internal/complex_impl.h" "$folder/COPYRIGHT"
    for patch in "${PATCHES[@]}"; do
        patch --directory="$1/opensubdiv" --strip=1 --fuzz=0 <"$patch"
    done
    cp "$1/opensubdiv/LICENSE.txt" "$1/licenses/opensubdiv.txt"
    cp "$1/opensubdiv/NOTICE.txt" "$1/licenses/opensubdiv-notice.txt"
    cp "$1/nlopt/COPYING" "$1/licenses/nlopt.txt"
    cp "$1/musl/COPYRIGHT" "$1/licenses/musl.txt"
    cp "$1/nlopt/src/algs/luksan/COPYRIGHT" "$1/licenses/nlopt-luksan.txt"
}

main() {
    [ -d "$UNPACKED" ] && return
    mkdir -p "$CACHE"
    exec 6>"$CACHE/library-sources.lock"
    flock 6
    [ -d "$UNPACKED" ] && return
    local work
    work=$(mktemp -d "$CACHE/library-sources.XXXXXX")
    trap "rm -rf '$work'" EXIT
    have_archives || fetch_archives "$work"
    unpack "$work/sources"
    mv "$work/sources" "$UNPACKED"
}

main >&2
printf '%s\n' "$UNPACKED"
