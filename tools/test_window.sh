#!/usr/bin/env bash
# The add-on in a real window of Blender, on a screen of its own; pictures go to out/window.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build blender window
"$ROOT/tools/build.sh"
blender=$(find_blender) || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
for name in RESOURCES CONFIG SCRIPTS; do
    folder=$ROOT/build/test-results/window/${name,,}
    mkdir -p "$folder"
    export "BLENDER_USER_$name=$folder"
done
exec xvfb-run --auto-servernum --server-args '-screen 0 1280x800x24 +extension GLX' \
    env LIBGL_ALWAYS_SOFTWARE=1 "$blender" --factory-startup --enable-event-simulate \
    --python "$ROOT/blender_tests/window/drive.py" -- "$ROOT/out/window" "$@"
