#!/usr/bin/env bash
# Formats and common mistakes, in C++ and Python; changes nothing.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/setup_system.sh" build lint
"$ROOT/tools/setup_python.sh"
cd "$ROOT"
mkdir -p build
PATH=$VENV/bin:$PATH
status=0
check() {
    say "$1"
    "${@:2}" || status=1
}

mapfile -t sources < <(find native -name '*.cpp' | sort)
mapfile -t headers < <(find native -name '*.h' | sort)

# clang-tidy reads the headers as they are written, without the precompiled one.
cmake -G Ninja -S . -B build/lint -DILLUSTRATE_PRECOMPILED_HEADERS=OFF -DILLUSTRATE_UNITY_BUILD=OFF -DILLUSTRATE_TESTS=ON \
    "-DPython_EXECUTABLE=$VENV/bin/python" \
    "-Dpybind11_DIR=$(python -m pybind11 --cmakedir)" >build/lint.log ||
    { cat build/lint.log && fail "CMake could not configure the build"; } >&2

tidy() { printf '%s\n' "${sources[@]}" | xargs -P "$JOBS" -n 4 clang-tidy --quiet -p build/lint; }

check clang-format clang-format --dry-run -Werror "${sources[@]}" "${headers[@]}"
check "ruff check" ruff check .
check "ruff format" ruff format --check .
# One folder at a time: several have a conftest.py.
for folder in native/illustrate_native native/benchmarks native/tests/python tools addon \
    farm/tests blender_tests examples; do
    check "mypy $folder" mypy "$folder"
done
check clang-tidy tidy
check "one-definition rule" build_unoptimised illustrate_tests _core
exit "$status"
