#!/usr/bin/env bash
# The wheels and the packages for macOS, compiled and checked here. They have never run: nothing on
# this machine can run them.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/cross.sh" macos-arm64
"$ROOT/tools/cross.sh" macos-x64
