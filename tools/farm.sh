#!/usr/bin/env bash
# The job templates for real: Slurm with two nodes on loopback, openjd-cli, Node. All of it ends with
# this script, however that ends. farm.sh [PYTEST ARGUMENT...]: such as -k openjd.
# ILLUSTRATE_NODE_KILLS: how often a node is killed at a random moment, 3 if left out.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ "$(id -u)" = 0 ] || fail "only root can start nodes of Slurm: run this as root (sudo make farm)"
"$ROOT/tools/setup_system.sh" build blender farm
"$ROOT/tools/build.sh"
"$ROOT/tools/setup_python.sh" "$ROOT/build/farm" "$ROOT/tools/requirements_farm.txt"
BLENDER=$(find_blender) || fail "no Blender at '${BLENDER:-blender}': set BLENDER to the program"
export BLENDER TMPDIR=/run
exec "$ROOT/tools/own_machine.sh" "$ROOT/build/farm/bin/python" -m pytest -q -ra \
    --rootdir "$ROOT" -p no:cacheprovider --basetemp /run/illustrate "$ROOT/farm/tests" "$@"
