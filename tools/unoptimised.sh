#!/usr/bin/env bash
# The C++ tests in a build of its own without optimisation, with the asserts of Eigen and of the
# standard library.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

PATH=$VENV/bin:$PATH

"$ROOT/tools/setup_system.sh" build test
"$ROOT/tools/setup_python.sh"
mkdir -p "$ROOT/build"
say "building without optimisation"
build_unoptimised illustrate_tests
say "C++ tests"
"$ROOT/build/unoptimised/illustrate_tests" --gtest_brief=1
say "the tests pass without optimisation"
