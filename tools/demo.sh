#!/usr/bin/env bash
# Builds, then illustrates the example scenes in a real Blender, headless: out/demo. Without
# arguments pictures of those that move and the curvature of three surfaces as well.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build blender
"$ROOT/tools/build.sh"
blender=$(find_blender) || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
"$blender" -b --factory-startup --python-exit-code 3 --python "$ROOT/examples/demo.py" -- \
    --out "$ROOT/out/demo" "$@"
[ $# = 0 ] || exit 0

for sequence in turntable robot; do
    [ ! -d "$ROOT/out/demo/$sequence" ] ||
        "$VENV/bin/python" "$ROOT/examples/motion.py" "$ROOT/out/demo/$sequence" "$sequence"
done

# curvature X Y Z SURFACE: seen from there.
curvature() {
    "$VENV/bin/python" "$ROOT/examples/curvature.py" --out "$ROOT/out/demo" \
        --toward-camera "$1" "$2" "$3" "$4"
}
curvature 0.35 0.2 1 "$ROOT/out/demo/suzanne.obj"
curvature -1.1 -0.75 1 klein
spot=${ILLUSTRATE_SHARED:-$ROOT/../shared}/meshes/smooth/spot_cage.obj
[ ! -f "$spot" ] || curvature -0.9 0.35 -1.3 "$spot"
