# Sourced by the other scripts: where things are, and the few words they share.
set -euo pipefail

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
VENV=$ROOT/.venv
CACHE=${ILLUSTRATE_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/illustrate}
JOBS=${JOBS:-2}

say() { printf '%s\n' "illustrate: $*"; }
fail() {
    printf '%s\n' "illustrate: error: $*" >&2
    exit 1
}

# recipe_hash FILE...: names what a cached result depends on, the compiler included.
recipe_hash() {
    { cat "$@" && "${CXX:-g++}" -dumpversion && "${CXX:-g++}" -dumpmachine; } |
        sha256sum | cut -c1-16
}

# find_python: the first Python 3.11 on the path that can make environments and build modules.
find_python() {
    local candidate
    for candidate in $(type -ap python3.11 python3) /usr/bin/python3.11; do
        if "$candidate" - 2>/dev/null <<'CHECK'; then
import ensurepip, os, sys, sysconfig, venv
header = os.path.join(sysconfig.get_paths()["include"], "Python.h")
sys.exit(sys.version_info[:2] != (3, 11) or not os.path.exists(header))
CHECK
            printf '%s\n' "$candidate"
            return
        fi
    done
    return 1
}

# find_blender: $BLENDER, else the one on the path.
find_blender() { command -v "${BLENDER:-blender}"; }

# python_of_blender PROGRAM: such as 3.11
python_of_blender() {
    "$1" -b --factory-startup --python-expr \
        'import sys; print("Python %d.%d of Blender" % sys.version_info[:2])' 2>/dev/null |
        sed -n 's/^Python \([0-9.]*\) of Blender$/\1/p'
}
