#!/usr/bin/env bash
# Builds, then illustrates the example scenes in a real Blender, headless: out/demo.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build blender
"$ROOT/tools/build.sh"
blender=$(find_blender) || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
"$blender" -b --factory-startup --python-exit-code 3 --python "$ROOT/examples/demo.py" -- \
    --out "$ROOT/out/demo" "$@"
