# Sourced after common.sh: packages of a built module, in dist.

# copy_licenses FOLDER: of what every module has inside; CMake has put those of its libraries there.
copy_licenses() {
    local pybind11
    cp /usr/share/doc/libeigen3-dev/copyright "$1/eigen.txt"
    pybind11=$("$VENV/bin/python" -c 'import importlib.metadata as m, pathlib
print(next(f.locate() for f in m.files("pybind11") if pathlib.PurePath(f).name == "LICENSE"))')
    cp "$pybind11" "$1/pybind11.txt"
}

# install_for_package PLATFORM BUILD: all that a package holds of the module. Prints the folder
# illustrate_native.
install_for_package() {
    local prefix=$ROOT/build/package/$1
    local installed=$prefix/illustrate_native
    rm -rf "$prefix"
    "$VENV/bin/cmake" --install "$2" --component module --prefix "$prefix" >/dev/null
    find "$2/pythons" \( -name '_core.*.so' -o -name '_core.*.pyd' \) -exec cp {} "$installed/" \;
    copy_licenses "$installed/licenses"
    printf '%s\n' "$installed"
}

# make_packages PLATFORM INSTALLED: in place of those of the same platform.
make_packages() {
    rm -f "$ROOT"/dist/illustrate-*-"$1".zip
    "$VENV/bin/python" "$ROOT/tools/package.py" --platform "$1" --installed "$2"
}
