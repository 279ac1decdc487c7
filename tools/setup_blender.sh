#!/usr/bin/env bash
# setup_blender.sh SOURCE VERSION PYTHON: one Blender of blenders.txt, kept in the cache.
# Prints the program (system), the interpreter that has bpy (wheel), or the root folder (the name
# of another Debian).
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

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

# wheel VERSION PYTHON FOLDER: with the numpy of its time, which some modules do not ask for.
wheel() {
    local numpy=numpy
    case $1 in 4.* | 5.0.*) numpy="numpy<2" ;; esac
    "$(find_python "$2")" -m venv "$3" &&
        "$3/bin/python" -m pip install --quiet --disable-pip-version-check --only-binary bpy \
            "bpy==$1" "$numpy" "$PYTEST"
}

# root SUITE FOLDER: needs the rights of root, and no mounts.
root() {
    local mirror
    mirror=$(debian_mirror | sed -n '1p')
    debootstrap --variant=minbase "$1" "$2" "$mirror" &&
        echo 'Acquire::Check-Valid-Until "false";' >"$2/etc/apt/apt.conf.d/20-valid-until" &&
        chroot "$2" apt-get -qq update &&
        DEBIAN_FRONTEND=noninteractive chroot "$2" apt-get -qq -y install \
            --no-install-recommends blender python3-numpy python3-pytest python3-cattr \
            python3-requests xvfb xauth imagemagick libgl1-mesa-dri libegl1 &&
        chroot "$2" apt-get clean
}

source=$1 version=$2 python=$3
case $source in
    system)
        "$ROOT/tools/setup_system.sh" blender >&2
        find_blender || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
        ;;
    wheel)
        find_python "$python" >/dev/null || fail "Blender $version needs Python $python with its" \
            "headers, on the path or as a version of pyenv"
        in_cache "$CACHE/bpy-$version" wheel "$version" "$python"
        printf '%s\n' "$CACHE/bpy-$version/bin/python"
        ;;
    *)
        [ "$(id -u)" = 0 ] || fail "Blender $version runs in a root folder of Debian $source, which" \
            "only root can make and enter: run this as root"
        "$ROOT/tools/setup_system.sh" root >&2
        in_cache "$CACHE/root-$source" root "$source"
        printf '%s\n' "$CACHE/root-$source"
        ;;
esac
