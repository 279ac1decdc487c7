#!/usr/bin/env bash
# The sources of OpenSubdiv, patched, and of NLopt, from the archives that Debian publishes, held to
# checksums. Prints the folder that holds opensubdiv/, nlopt/ and licenses/ as its last line.
# ILLUSTRATE_SOURCES may name a folder that already holds the two archives.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/debian_packages.sh"

OPENSUBDIV=opensubdiv_3.5.0.orig.tar.xz
OPENSUBDIV_SHA256=8bc452ad9934d69bd2b03662e9d86a3d014d95445dc599013e523e577ae90693
NLOPT=nlopt_2.7.1.orig.tar.gz
NLOPT_SHA256=db88232fa5cef0ff6e39943fc63ab6074208831dc0031cf1545f6ecd31ae2a1a
PATCHES=("$ROOT"/tools/patches/*.patch)

SOURCES=${ILLUSTRATE_SOURCES:-$CACHE/sources}
UNPACKED=$CACHE/library-sources-$(cat "${BASH_SOURCE[0]}" "${PATCHES[@]}" | sha256sum | cut -c1-16)

have_archives() {
    has_checksum "$SOURCES/$OPENSUBDIV" "$OPENSUBDIV_SHA256" &&
        has_checksum "$SOURCES/$NLOPT" "$NLOPT_SHA256"
}

fetch_archives() {
    local work=$1/apt
    say "fetching the sources of OpenSubdiv and NLopt"
    own_package_sources "$work"
    (cd "$work" && "${APT[@]}" update && "${APT[@]}" source --download-only opensubdiv nlopt) >&2 ||
        fail "cannot fetch the sources. Put $OPENSUBDIV and $NLOPT into a folder and set" \
            "ILLUSTRATE_SOURCES to it, or configure with -DILLUSTRATE_SYSTEM_LIBRARIES=ON."
    mkdir -p "$SOURCES"
    for archive in "$OPENSUBDIV" "$NLOPT"; do
        [ -f "$work/$archive" ] || fail "this Debian does not publish $archive (Debian 12 does)"
        mv "$work/$archive" "$SOURCES/"
    done
    have_archives || fail "a source archive in $SOURCES does not have the expected checksum"
}

# unpack FOLDER: the patched sources of both, and the licences of what the module takes from them.
unpack() {
    local patch
    mkdir -p "$1/opensubdiv" "$1/nlopt" "$1/licenses"
    tar -xf "$SOURCES/$OPENSUBDIV" -C "$1/opensubdiv" --strip-components=1
    tar -xf "$SOURCES/$NLOPT" -C "$1/nlopt" --strip-components=1
    for patch in "${PATCHES[@]}"; do
        patch --directory="$1/opensubdiv" --strip=1 --fuzz=0 <"$patch"
    done
    cp "$1/opensubdiv/LICENSE.txt" "$1/licenses/opensubdiv.txt"
    cp "$1/opensubdiv/NOTICE.txt" "$1/licenses/opensubdiv-notice.txt"
    cp "$1/nlopt/COPYING" "$1/licenses/nlopt.txt"
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
