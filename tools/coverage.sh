#!/usr/bin/env bash
# coverage.sh [cpp] [python]: which lines no test runs, the worst files first; both where none is
# named. Lists go to out/coverage. C++: the C++ tests, in a build of its own. Python: the module's
# own files, by its Python tests; the add-on runs inside Blender and is not measured.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

BUILD=$ROOT/build/coverage OUT=$ROOT/out/coverage TOOLS=$ROOT/build/coverage/venv
PATH=$VENV/bin:$PATH
PACKAGE=illustrate_native

cpp() {
    "$ROOT/tools/setup_system.sh" build test
    say "building for coverage"
    configure "$BUILD/native" "$VENV/bin/python" -DCMAKE_BUILD_TYPE=Unoptimised \
        -DILLUSTRATE_TESTS=ON "-DCMAKE_CXX_FLAGS=--coverage"
    compile "$BUILD/native" illustrate_tests
    find "$BUILD/native" -name '*.gcda' -delete
    say "C++ tests"
    "$BUILD/native/illustrate_tests" --gtest_brief=1
    "$TOOLS/bin/gcovr" --root "$ROOT/native" --filter "$ROOT/native/" \
        --exclude "$ROOT/native/tests/" --sort uncovered-percent --sort-reverse \
        --txt "$OUT/cpp.txt" --print-summary "$BUILD/native"
}

# measured ARGUMENTS...: coverage.py in the environment that holds the module.
measured() {
    COVERAGE_FILE=$BUILD/python.data PYTHONPATH=$(echo "$TOOLS"/lib/python*/site-packages) \
        "$VENV/bin/python" -m coverage "$@"
}

python_files() {
    say "Python tests"
    cd "$ROOT"
    measured run --branch --source "$PACKAGE" -m pytest -q native/tests/python
    measured report --sort cover --skip-covered | tee "$OUT/python.txt"
}

"$ROOT/tools/setup_python.sh"
mkdir -p "$OUT" "$BUILD"
"$ROOT/tools/setup_python.sh" "$TOOLS" "$ROOT/tools/requirements_coverage.txt"
if [[ " ${*:-cpp python} " == *" cpp "* ]]; then cpp; fi
if [[ " ${*:-cpp python} " == *" python "* ]]; then
    "$ROOT/tools/build.sh"
    python_files
fi
say "the lists are in out/coverage"
