#!/usr/bin/env bash
# cross.sh PLATFORM: the module for windows-x64, macos-arm64 or macos-x64, compiled on this machine,
# and its packages in dist, checked for what they ask of the system.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/packaging.sh"

PYTHONS=(3.11 3.13) # of the Blenders, 4.2 and later, that there are for these systems
platform=$1
case $platform in
    windows-x64) triple=x86_64-windows-gnu ;;
    macos-arm64) triple=aarch64-macos.11.0 ;;
    macos-x64) triple=x86_64-macos.11.0 ;;
    *) fail "no platform $platform is known here: windows-x64, macos-arm64 or macos-x64" ;;
esac
BUILD=$ROOT/build/$platform
PATH=$VENV/bin:$PATH

# headers VERSION: their folders, as ILLUSTRATE_PYTHON_HEADERS has them. Those for Linux serve macOS
# too, where types have the same sizes.
headers() {
    if [ "$platform" = windows-x64 ]; then
        printf '%s/include\n' "$("$ROOT/tools/setup_windows_python.sh" "$1")"
    else
        "$ROOT/tools/setup_headers.sh" "$1"
    fi
}

# Of the libraries of C and C++ that the compiler links into the module.
copy_runtime_licenses() {
    local zig=$1 folder=$2 name
    zig=$("$zig/bin/python" -c 'import ziglang, pathlib; print(pathlib.Path(ziglang.__file__).parent)')
    for name in libcxx libcxxabi libunwind; do
        cp "$zig/lib/$name/LICENSE.TXT" "$folder/$name.txt"
    done
    cp "$zig/LICENSE" "$folder/zig.txt" # compiler_rt, and functions of the C library
    [ "$platform" != windows-x64 ] || cp "$zig/lib/libc/mingw/COPYING" "$folder/mingw-w64.txt"
}

"$ROOT/tools/setup_system.sh" build
"$ROOT/tools/setup_python.sh"
zig=$("$ROOT/tools/setup_zig.sh")
sources=$("$ROOT/tools/setup_library_sources.sh")
list=
for version in "${PYTHONS[@]}"; do
    folders=$(headers "$version")
    list="$list${list:+;}$version=$folders"
done
mkdir -p "$ROOT/build"
exec 9>"$BUILD.lock"
flock 9
# NLopt's scripts ask for an old CMake policy, while building too.
export CMAKE_POLICY_VERSION_MINIMUM=3.5
# What another compiler warns of stops no package.
configure "$BUILD" -DCMAKE_COMPILE_WARNING_AS_ERROR=OFF \
    "-DCMAKE_TOOLCHAIN_FILE=$ROOT/cmake/zig.cmake" "-DILLUSTRATE_ZIG=$zig" \
    "-DILLUSTRATE_TRIPLE=$triple" "-DILLUSTRATE_LIBRARY_SOURCES=$sources" \
    "-DEigen3_DIR=/usr/share/eigen3/cmake" "-DILLUSTRATE_PYTHON_HEADERS=$list"
compile "$BUILD" "${PYTHONS[@]/#/_core_}"
installed=$(install_for_package "$platform" "$BUILD")
copy_runtime_licenses "$zig" "$installed/licenses"
"$zig/bin/python" "$ROOT/tools/check_binaries.py" "$platform" "$installed"/_core.*
make_packages "$platform" "$installed"
