#!/usr/bin/env bash
# setup_system.sh GROUP...: installs the Debian packages that are missing. --list GROUP...: names them.
# Groups: build, test, lint, window, wine, root, bpy (what the official module asks of the system), farm,
# blender (unless $BLENDER or another Blender on the path is there).
# As root or with a sudo that asks nothing; else prints the command to run and fails.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

has_own_blender() {
    [ -n "${BLENDER:-}" ] && return
    local program
    program=$(command -v blender) && [ "$(readlink -f "$program")" != /usr/bin/blender ]
}

packages_of() {
    case $1 in
        build)
            echo g++ make patch xz-utils libeigen3-dev
            find_python >/dev/null || echo python3.11 python3.11-venv python3.11-dev
            ;;
        test) echo libgtest-dev poppler-utils && packages_of bpy ;;
        bpy)
            echo libegl1 libgl1 libgl1-mesa-dri libice6 libsm6 libx11-6 libxext6 \
                libxfixes3 libxi6 libxkbcommon0 libxrender1
            ;;
        root) echo debootstrap ;;
        wine) echo wine wine64 ;;
        farm)
            echo slurmctld slurmd munge iproute2
            command -v node >/dev/null || echo nodejs
            ;;
        window) echo xvfb xauth imagemagick libgl1-mesa-dri ;;
        lint) echo clang-format clang-tidy libgtest-dev ;;
        blender) has_own_blender || echo blender python3-numpy libegl1 libgl1-mesa-dri ;;
        *) fail "no such group of packages: $1" ;;
    esac
}

is_installed() {
    [ "$(dpkg-query --show --showformat '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing_packages() {
    local package
    for package in $(for group in "$@"; do packages_of "$group"; done | tr ' ' '\n' | sort -u); do
        is_installed "$package" || echo "$package"
    done
}

install_packages() {
    local apt=(apt-get -o DPkg::Lock::Timeout=300)
    local as_root=()
    if [ "$(id -u)" != 0 ]; then
        sudo -n true 2>/dev/null || fail "Debian packages are missing. Run:
  sudo apt-get update && sudo apt-get install --no-install-recommends $*"
        as_root=(sudo)
    fi
    say "installing $*"
    "${as_root[@]}" "${apt[@]}" -qq update
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        "${apt[@]}" -qq -y install --no-install-recommends "$@" >&2
}

if [ "${1:-}" = --list ]; then
    for group in "${@:2}"; do packages_of "$group"; done
    exit
fi
if ! command -v dpkg-query >/dev/null; then
    say "not a Debian system: make sure that these are there:" \
        $(for group in "$@"; do packages_of "$group"; done)
    exit 0
fi
packages=$(missing_packages "$@")
[ -z "$packages" ] || install_packages $packages
