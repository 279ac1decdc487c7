#!/usr/bin/env bash
# .venv: Python 3.11 with the packages of requirements.txt; made anew when these change.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

requirements=$ROOT/tools/requirements.txt
if [ -x "$VENV/bin/python" ] && cmp --silent "$requirements" "$VENV/requirements.txt"; then
    exit
fi
python=$(find_python) || fail "no Python 3.11 with venv and headers on the path"
say "installing ${requirements##*/} into $VENV"
"$python" -m venv "$VENV"
"$VENV/bin/python" -m pip install --quiet --disable-pip-version-check \
    --requirement "$requirements" >&2
cp "$requirements" "$VENV/requirements.txt"
