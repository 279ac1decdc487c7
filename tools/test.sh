#!/usr/bin/env bash
# Sets up what the tests need, builds, and runs every suite.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build test blender
"$ROOT/tools/build.sh" tests
"$ROOT/tools/extension.sh" 3.13 # of the Blenders that run_tests.py names
say "set-up, build and packages took $SECONDS s"
exec "$VENV/bin/python" "$ROOT/tools/run_tests.py"
