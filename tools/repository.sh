#!/usr/bin/env bash
# An extension repository of the packages that are in dist, in out/repository: its index for Blender
# (index.json), a page for people (index.html), and the packages. Put the folder on any web server.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

BLENDER_WITH_TOOL=(wheel 4.2.23 3.11) # of blenders.txt, the oldest that takes extensions
folder=$ROOT/out/repository

packages=$(find "$ROOT/dist" -maxdepth 1 -name 'illustrate-*.zip' ! -name '*-legacy-*' 2>/dev/null)
if [ -z "$packages" ]; then
    "$ROOT/tools/extension.sh"
    packages=$(find "$ROOT/dist" -maxdepth 1 -name 'illustrate-*.zip' ! -name '*-legacy-*')
fi
"$ROOT/tools/setup_system.sh" bpy
python=$("$ROOT/tools/setup_blender.sh" "${BLENDER_WITH_TOOL[@]}")
tool=$("$python" -c 'import importlib.util, pathlib
bpy = pathlib.Path(importlib.util.find_spec("bpy").origin).parent
print(*bpy.glob("*/scripts/addons_core/bl_pkg/cli/blender_ext.py"))')
rm -rf "$folder"
mkdir -p "$folder"
for package in $packages; do
    "$python" "$tool" validate "$package"
    cp "$package" "$folder/"
done
"$python" "$tool" server-generate --repo-dir "$folder" --html
say "made $folder of $(wc -w <<<"$packages") packages"
