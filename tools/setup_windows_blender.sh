#!/usr/bin/env bash
# setup_windows_blender.sh VERSION PYTHON: the official module bpy for Windows with what the tests
# need, in the cache: 340 MB to fetch for each. Prints its program python.exe.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

version=$1 python=$2

# numpy as in that Blender, or of its time.
packages() {
    printf '%s\n' "bpy==$version" pytest==9.2.0 colorama pyelftools==0.33
    case $version in 4.* | 5.0.*) echo "numpy<2" "scipy<1.15" ;; *) echo numpy scipy ;; esac
}

make() {
    local wanted
    read -r -d '' -a wanted < <(packages && printf '\0')
    cp -r "$("$ROOT/tools/setup_windows_python.sh" "$python")/program" "$1" &&
        rm "$1"/python*._pth && # without it the program looks for packages as any Python does
        "$VENV/bin/python" -m pip install --quiet --disable-pip-version-check --no-compile \
            --platform win_amd64 --python-version "$python" --ignore-requires-python \
            --only-binary :all: --target "$1/Lib/site-packages" "${wanted[@]}"
}

"$ROOT/tools/setup_python.sh"
folder=$CACHE/windows-bpy-$version
mkdir -p "$CACHE"
exec 9>"$folder.lock"
flock 9
if [ ! -d "$folder" ]; then
    work=$(mktemp -d "$CACHE/windows-bpy.XXXXXX")
    trap 'rm -rf "$work"' EXIT
    say "fetching Blender $version for Windows" >&2
    make "$work/made" >"$folder.log" 2>&1 || fail "that failed: see $folder.log"
    mv "$work/made" "$folder"
fi
printf '%s\n' "$folder/python.exe"
