#!/usr/bin/env bash
# docs.sh [--light]: the documentation site, in out/docs; nothing is fetched by its pages, and a
# broken link is an error. --light: without the pictures of settings.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/build.sh"
"$ROOT/tools/setup_python.sh" "$ROOT/build/docs/venv" "$ROOT/tools/requirements_docs.txt"
cd "$ROOT"
say "drawing the pictures of the settings"
"$VENV/bin/python" tools/docs/site.py build/docs/source "$@"
build/docs/venv/bin/sphinx-build -q -W --keep-going -b html build/docs/source out/docs
say "the site is in out/docs/index.html"
