#!/usr/bin/env bash
# setup_blender.sh SOURCE VERSION PYTHON: one Blender of blenders.txt, kept in the cache.
# Prints the program (system), the interpreter that has bpy (wheel), or the root folder (the name
# of another Debian; a wheel whose Python this machine has not: its interpreter is /opt/bpy in there).
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/root_folders.sh"

PYTEST=pytest==9.2.0

# in_cache FOLDER: makes the folder by "$2...", whole or not at all; nobody else at the same time.
in_cache() {
    local folder=$1
    mkdir -p "$CACHE"
    exec 8>"$folder.lock"
    flock 8
    [ -e "$folder/complete" ] && return
    rm -rf "$folder"
    "${@:2}" "$folder" >"$folder.log" 2>&1 ||
        { tail -n 20 "$folder.log" && fail "could not set up ${folder##*/}: see $folder.log"; } >&2
    touch "$folder/complete"
}

# wheel_packages VERSION: with the numpy of its time, which some modules do not ask for.
wheel_packages() {
    printf '%s\n' "bpy==$1" "$PYTEST"
    case $1 in 4.* | 5.0.*) echo "numpy<2" ;; *) echo numpy ;; esac
}

# wheel VERSION PYTHON FOLDER
wheel() {
    local packages
    mapfile -t packages < <(wheel_packages "$1")
    "$(find_python "$2")" -m venv "$3" &&
        "$3/bin/python" -m pip install --quiet --disable-pip-version-check --only-binary bpy \
            "${packages[@]}"
}

# debian SUITE FOLDER PACKAGE...: a root folder; needs the rights of root, and no mounts.
debian() {
    debootstrap --variant=minbase "$1" "$2" "$(debian_mirror | sed 1q)" &&
        python_registry_settings "$2" &&
        echo 'Acquire::Check-Valid-Until "false";' >"$2/etc/apt/apt.conf.d/20-valid-until" &&
        chroot "$2" apt-get -qq update &&
        DEBIAN_FRONTEND=noninteractive chroot "$2" apt-get -qq -y install \
            --no-install-recommends "${@:3}" &&
        chroot "$2" apt-get clean
}

# program_root SUITE FOLDER: with Debian's own Blender.
program_root() {
    debian "$1" "$2" blender python3-numpy python3-pytest python3-cattr python3-requests xvfb \
        xauth imagemagick libgl1-mesa-dri libegl1
}

# wheel_root VERSION PYTHON FOLDER: with the official module.
wheel_root() {
    local packages variables
    mapfile -t packages < <(wheel_packages "$1")
    mapfile -t variables < <(registry_variables)
    debian "$(suite_of_python "$2")" "$3" "python$2-venv" ca-certificates \
        $("$ROOT/tools/setup_system.sh" --list bpy) &&
        chroot "$3" "python$2" -m venv /opt/bpy &&
        "$ROOT/tools/enter_root.sh" "$3" /usr/bin/env "${variables[@]}" HOME=/root \
            /opt/bpy/bin/python -m pip install --quiet --disable-pip-version-check \
            --no-cache-dir --only-binary bpy "${packages[@]}"
}

need_root() {
    [ "$(id -u)" = 0 ] || fail "Blender $version runs in a root folder of Debian $1, which only" \
        "root can make and enter: run this as root${2:+, or $2}"
    "$ROOT/tools/setup_system.sh" root >&2
}

source=$1 version=$2 python=$3
case $source in
    system)
        "$ROOT/tools/setup_system.sh" blender >&2
        find_blender || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
        ;;
    wheel)
        if find_python "$python" >/dev/null; then
            in_cache "$CACHE/bpy-$version" wheel "$version" "$python"
            printf '%s\n' "$CACHE/bpy-$version/bin/python"
            exit
        fi
        suite=$(suite_of_python "$python") || fail "Blender $version needs Python $python with" \
            "its headers, on the path or as a version of pyenv"
        need_root "$suite" "install Python $python with its headers"
        in_cache "$CACHE/root-bpy-$version" wheel_root "$version" "$python"
        printf '%s\n' "$CACHE/root-bpy-$version"
        ;;
    *)
        need_root "$source"
        in_cache "$CACHE/root-$source" program_root "$source"
        printf '%s\n' "$CACHE/root-$source"
        ;;
esac
