#!/usr/bin/env bash
# windows.sh [VERSION...] [-k EXPR]: the wheels and the package for Windows, compiled here, and their
# tests in the Python and Blender of Windows (of these versions, 4.5.15 unless said), under wine.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/cross.sh" windows-x64
"$ROOT/tools/build.sh"
"$ROOT/tools/setup_wine.sh" >/dev/null
"$ROOT/tools/setup_system.sh" bpy
exec "$VENV/bin/python" "$ROOT/tools/run_windows.py" "$@"
