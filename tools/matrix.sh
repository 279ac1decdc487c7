#!/usr/bin/env bash
# matrix.sh [VERSION...] [--no-window | --window [SCENARIO...]]: the built packages, installed as a
# user would, and all tests in the Blenders of blenders.txt, or those in a window alone. Blenders are
# kept in the cache: 370 MB to fetch for each.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build test blender window
"$ROOT/tools/extension.sh"
exec "$VENV/bin/python" "$ROOT/tools/run_matrix.py" "$@"
