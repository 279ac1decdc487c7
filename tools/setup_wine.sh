#!/usr/bin/env bash
# wine, and a folder of the cache that is its Windows 10. Prints that folder.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" wine window >&2
folder=$CACHE/wine
mkdir -p "$CACHE"
exec 9>"$folder.lock"
flock 9
if [ ! -e "$folder/complete" ]; then
    say "making a Windows for wine" >&2
    rm -rf "$folder"
    mkdir -p "$folder"
    wine="env WINEPREFIX=$folder WINEDEBUG=-all wine"
    { $wine wineboot --init && $wine reg add 'HKCU\Software\Wine' /v Version /d win10 /f; } \
        </dev/null 2>&1 9>&- | cat >"$folder.log" || fail "that failed: see $folder.log"
    touch "$folder/complete"
fi
printf '%s\n' "$folder"
