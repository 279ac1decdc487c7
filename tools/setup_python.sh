#!/usr/bin/env bash
# .venv: Python 3.11 with the packages of requirements.txt.
# setup_python.sh bpy: instead, in the cache, Python 3.11 with the official Blender module; prints
# its interpreter.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# make_environment FOLDER REQUIREMENTS: does nothing when it was made from the same requirements.
make_environment() {
    local stamp=$1/requirements.txt
    if [ -x "$1/bin/python" ] && cmp --silent "$2" "$stamp"; then
        return
    fi
    local python
    python=$(find_python) || fail "no Python 3.11 with venv and headers on the path"
    say "installing ${2##*/} into $1"
    "$python" -m venv "$1"
    "$1/bin/python" -m pip install --quiet --disable-pip-version-check --requirement "$2" >&2
    cp "$2" "$stamp"
}

if [ "${1:-}" = bpy ]; then
    environment=$CACHE/$(sha256sum <"$ROOT/tools/requirements-bpy.txt" | cut -c1-16)-bpy
    make_environment "$environment" "$ROOT/tools/requirements-bpy.txt" >&2
    printf '%s\n' "$environment/bin/python"
else
    make_environment "$VENV" "$ROOT/tools/requirements.txt"
fi
