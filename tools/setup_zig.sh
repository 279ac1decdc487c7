#!/usr/bin/env bash
# The compiler for other systems, zig, in an environment of its own in the cache. Prints the folder
# that holds bin/python, which can read what was compiled, and the programs zig-cc, zig-c++ and so on.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

requirements=$ROOT/tools/requirements_cross.txt
folder=$CACHE/zig
mkdir -p "$CACHE"
exec 9>"$folder.lock"
flock 9
"$ROOT/tools/setup_python.sh" "$folder" "$requirements" >&2
for name in cc c++ ar ranlib rc dlltool; do
    [ -x "$folder/zig-$name" ] && continue
    printf '#!/bin/sh\nexec "%s" -m ziglang %s "$@"\n' "$folder/bin/python" "$name" >"$folder/new"
    chmod +x "$folder/new"
    mv "$folder/new" "$folder/zig-$name"
done
printf '%s\n' "$folder"
