#!/usr/bin/env bash
# Sets up what the tests need, builds, and runs every suite.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build test blender
"$ROOT/tools/build.sh" tests
bpy_python=$("$ROOT/tools/setup_python.sh" bpy)
blender=$(find_blender) || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
exec "$VENV/bin/python" "$ROOT/tools/run_tests.py" --blender "$blender" --bpy-python "$bpy_python"
