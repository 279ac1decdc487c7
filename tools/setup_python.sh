#!/usr/bin/env bash
# setup_python.sh [FOLDER REQUIREMENTS]: .venv with the packages of requirements.txt, or another
# environment of Python 3.11; made anew when these change.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

folder=${1:-$VENV} requirements=${2:-$ROOT/tools/requirements.txt}
if [ -x "$folder/bin/python" ] && cmp --silent "$requirements" "$folder/requirements.txt"; then
    exit
fi
python=$(find_python) || fail "no Python 3.11 with venv and headers on the path"
say "installing ${requirements##*/} into $folder"
"$python" -m venv "$folder"
"$folder/bin/python" -m pip install --quiet --disable-pip-version-check \
    --requirement "$requirements" >&2
cp "$requirements" "$folder/requirements.txt"
