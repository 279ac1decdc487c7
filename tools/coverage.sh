#!/usr/bin/env bash
# coverage.sh [cpp] [python] [addon]: which lines no test runs, the worst files first; all three where
# none is named. Lists go to out/coverage. C++: the C++ tests, in a build of its own. Python: the
# module's own files, by its Python tests. Add-on: its files, by its tests in $BLENDER, in the
# background, save the one of memory, which the measuring needs too; what a second process runs,
# such as a window or a farm, counts as not run.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

BUILD=$ROOT/build/coverage OUT=$ROOT/out/coverage TOOLS=$ROOT/build/coverage/venv
PATH=$VENV/bin:$PATH
PACKAGE=illustrate_native

# Threads count without regard to each other, now and then to less than nothing.
cpp() {
    "$ROOT/tools/setup_system.sh" build test
    say "building for coverage"
    configure "$BUILD/native" "$VENV/bin/python" -DCMAKE_BUILD_TYPE=Coverage \
        -DILLUSTRATE_TESTS=ON
    compile "$BUILD/native" illustrate_tests
    find "$BUILD/native" -name '*.gcda' -delete
    say "C++ tests"
    "$BUILD/native/illustrate_tests" --gtest_brief=1
    "$TOOLS/bin/gcovr" --root "$ROOT/native" --filter "$ROOT/native/" \
        --exclude "$ROOT/native/tests/" --sort uncovered-percent \
        --gcov-ignore-parse-errors negative_hits.warn_once_per_file \
        --txt "$OUT/cpp.txt" --print-summary "$BUILD/native"
}

# measured DATA ARGUMENTS...: coverage.py in the environment that holds the module.
measured() {
    COVERAGE_FILE=$BUILD/$1.data PYTHONPATH=$(site_packages) \
        "$VENV/bin/python" -m coverage "${@:2}"
}

site_packages() { echo "$TOOLS"/lib/python*/site-packages; }

# report DATA: its list.
report() { measured "$1" report --sort cover --skip-covered --show-missing | tee "$OUT/$1.txt"; }

python_files() {
    say "Python tests"
    cd "$ROOT"
    measured python run --branch --source "$PACKAGE" -m pytest -q native/tests/python
    report python
}

addon_files() {
    say "add-on tests"
    cd "$ROOT"
    ILLUSTRATE_COVERAGE=$BUILD/addon.data ILLUSTRATE_COVERAGE_SITE=$(site_packages) \
        "$(find_blender)" -b --factory-startup --python-exit-code 1 \
        --python blender_tests/run.py -- -q -k "not do_not_grow"
    report addon
}

"$ROOT/tools/setup_python.sh"
mkdir -p "$OUT" "$BUILD"
"$ROOT/tools/setup_python.sh" "$TOOLS" "$ROOT/tools/requirements_coverage.txt"
PARTS=" ${*:-cpp python addon} "
if [[ $PARTS == *" addon "* ]]; then "$ROOT/tools/setup_system.sh" build test blender; fi
if [[ $PARTS == *" cpp "* ]]; then cpp; fi
if [[ $PARTS == *" python "* || $PARTS == *" addon "* ]]; then "$ROOT/tools/build.sh"; fi
if [[ $PARTS == *" python "* ]]; then python_files; fi
if [[ $PARTS == *" addon "* ]]; then addon_files; fi
say "the lists are in out/coverage"
