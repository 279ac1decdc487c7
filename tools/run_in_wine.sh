#!/usr/bin/env bash
# run_in_wine.sh PROGRAM.exe ARGUMENTS...: runs a program for Windows, with its exit code. All files
# of this machine are on the drive Z:.
set -euo pipefail

export WINEPREFIX=${ILLUSTRATE_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/illustrate}/wine WINEDEBUG=-all
# Blender renders with OpenGL, which wine has where there is a display. A console of its own kind is
# where Python hangs: it gets files and pipes.
xvfb-run -a wine "$@" </dev/null 2>&1 | cat
