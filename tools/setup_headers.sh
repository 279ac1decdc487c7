#!/usr/bin/env bash
# setup_headers.sh VERSION: the headers of that Python. Prints their folders, with commas between:
# those of a Python on the path or of pyenv, else of the package of a newer Debian, in the cache.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/debian_packages.sh"

version=$1
if python=$(find_python "$version"); then
    "$python" -c 'import sysconfig; print(sysconfig.get_paths()["include"])'
    exit
fi
suite=$(suite_of_python "$version") || fail "no headers of Python $version: install it with them," \
    "or with 'pyenv install $version'"

fetch() {
    local work=$1 archive
    packages_of_suite deb "$suite" "$work" && "${APT[@]}" update &&
        (cd "$work" && "${APT[@]}" download "libpython$version-dev") || return
    for archive in "$work"/*.deb; do dpkg-deb --extract "$archive" "$work/files" || return; done
}

folder=$CACHE/python$version-headers
mkdir -p "$CACHE"
exec 9>"$folder.lock"
flock 9
if [ ! -d "$folder" ]; then
    work=$(mktemp -d "$CACHE/headers.XXXXXX")
    trap 'rm -rf "$work"' EXIT
    say "fetching the headers of Python $version from Debian $suite" >&2
    fetch "$work" >"$folder.log" 2>&1 || fail "that failed: see $folder.log"
    mv "$work/files/usr/include" "$folder"
fi
# pyconfig.h is in a folder of the machine's architecture, beside it.
printf '%s,%s\n' "$folder/python$version" "$folder"
