#!/usr/bin/env bash
# The tests of the native module under the address and undefined-behaviour sanitizers, in a build of
# its own, then nasty meshes for SANITIZE_FUZZ_SECONDS (60) from SANITIZE_FUZZ_SEED (1) on. Ends at
# the first finding.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

BUILD=$ROOT/build/sanitize
PYTHON=$VENV/bin/python
PATH=$VENV/bin:$PATH

export ASAN_OPTIONS=abort_on_error=1:detect_stack_use_after_return=1:detect_leaks=1
export UBSAN_OPTIONS=print_stacktrace=1:abort_on_error=1

# runtime NAME: where the compiler keeps a sanitizer's library.
runtime() { readlink -f "$("${CXX:-g++}" -print-file-name="$1")"; }

build() {
    cmake -G Ninja -S "$ROOT" -B "$BUILD" -DCMAKE_BUILD_TYPE=Sanitize -DILLUSTRATE_TESTS=ON \
        "-DPython_EXECUTABLE=$PYTHON" "-Dpybind11_DIR=$(python -m pybind11 --cmakedir)" \
        >"$BUILD.log" || { cat "$BUILD.log" && fail "CMake could not configure the build"; } >&2
    cmake --build "$BUILD" --parallel "$JOBS"
    cmake --install "$BUILD" --component module --prefix "$BUILD/packages" >>"$BUILD.log"
}

# Python itself is not instrumented: it needs the runtimes first, and what it never frees is no leak
# of ours.
python_tests() {
    ASAN_OPTIONS=$ASAN_OPTIONS:detect_leaks=0 PYTHONMALLOC=malloc PYTHONPATH=$BUILD/packages \
        LD_PRELOAD="$(runtime libasan.so) $(runtime libubsan.so) $(runtime libstdc++.so)" \
        "$PYTHON" -m pytest -q -p no:cacheprovider "$ROOT/native/tests/python"
}

"$ROOT/tools/setup_system.sh" build test
"$ROOT/tools/setup_python.sh"
mkdir -p "$ROOT/build"
say "building with sanitizers"
build
say "C++ tests"
"$BUILD/illustrate_tests" --gtest_brief=1
say "Python tests"
python_tests
say "nasty meshes"
"$BUILD/illustrate_fuzz" --seconds "${SANITIZE_FUZZ_SECONDS:-60}" --seed "${SANITIZE_FUZZ_SEED:-1}"
say "the sanitizers found nothing"
