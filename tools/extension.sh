#!/usr/bin/env bash
# Packages of the add-on in dist: for Blender 4.2 and later, and for 3.4 to 4.1. In dist/wheels the
# module alone, for each Python; the one for Python 3.11 in dist as well. extension.sh VERSION...:
# for these Pythons besides 3.11 alone, which is quicker.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/packaging.sh"

PATH=$VENV/bin:$PATH
PYTHONS=() # besides 3.11, that of .venv

# The low floor of the packages comes from this compiler and the C library that it links with.
check_compiler() {
    local release
    release=$(. /etc/os-release 2>/dev/null && echo "${ID:-}-${VERSION_ID:-}")
    [ "$release" = debian-12 ] ||
        say "warning: built on $release, not on Debian 12: the package may ask for newer systems"
}

"$ROOT/tools/build.sh"
check_compiler
for version in 3.10 3.13 3.14; do
    if [ $# != 0 ] && [[ " $* " != *" $version "* ]]; then
        say "LEFT OUT of the packages, make extension has it: Python $version"
    elif "$ROOT/tools/setup_headers.sh" "$version" >/dev/null; then
        PYTHONS+=("$version")
    else
        say "LEFT OUT of the packages: Python $version"
    fi
done
exec 9>"$ROOT/build/build.lock"
flock 9
compile_for_pythons "${PYTHONS[@]}"
rm -rf "$ROOT"/dist/*.whl "$ROOT"/dist/wheels/*-manylinux*.whl
installed=$(install_for_package linux-x64 "$ROOT/build/native")
strip --strip-unneeded "$installed"/*.so
make_packages linux-x64 "$installed"
cp "$ROOT"/dist/wheels/*-cp311-*manylinux*.whl "$ROOT/dist/"
