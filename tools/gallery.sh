#!/usr/bin/env bash
# gallery.sh [FIGURE...]: the figures of examples/figures, drawn in a real Blender into out/gallery;
# those drawn go into docs/gallery, small, and docs/gallery.md is written from the scripts.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build blender
"$ROOT/tools/build.sh"
blender=$(find_blender) || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
"$blender" -b --factory-startup --python-exit-code 3 --python "$ROOT/examples/gallery.py" -- \
    --out "$ROOT/out/gallery" "$@"
"$VENV/bin/python" "$ROOT/tools/gallery_page.py"
