#!/usr/bin/env bash
# Builds, then runs every benchmark: JSON lines of counts and times, and tables.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$ROOT/tools/build.sh" >&2
for benchmark in "$ROOT"/native/benchmarks/bench_*.py; do
    "$VENV/bin/python" "$benchmark" "$@"
done
