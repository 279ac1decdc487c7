#!/usr/bin/env bash
# Draws the frames of a .blend as a Slurm array and merges them into keyframes (docs/farm.md).
#
#     illustrate.sh FILE.blend OUT INTO.blend FIRST LAST [CHUNK]
#
# Prints the numbers of the two jobs. The second begins when the first has ended, however it ended:
# it says which frames failed and why, and merges where all are there. The same command again draws
# what is missing. In the environment:
#     BLENDER    the program
#     SCRIPT     headless.py, for Blenders without the command of the extension
#     RESOURCES  a BLENDER_USER_RESOURCES with the extension; each task gets a copy on its own node
#     WARM_UP    frames drawn before each chunk
#     FORMATS    with json
#     MOST       tasks at a time
#     LOGS       the folder of the tasks' logs, OUT/logs if left out
#     SBATCH_... as for every job
set -eu

own_resources() { # so that no two tasks install the wheels of extensions at one place
    [ -n "${RESOURCES:-}" ] || return 0
    own=$(mktemp -d "${TMPDIR:-/tmp}/illustrate.XXXXXX")
    trap 'rm -rf "$own"' EXIT
    cp -R "$RESOURCES/." "$own"
    export BLENDER_USER_RESOURCES=$own
}

illustrate() { # ARGUMENTS: of Blender, then --, then of the command
    local opened=() start=(--command illustrate) status=0
    while [ "$1" != -- ]; do
        opened+=("$1")
        shift
    done
    shift
    [ -z "${SCRIPT:-}" ] || start=(--python-exit-code 3 --python "$SCRIPT" --)
    own_resources
    "${BLENDER:-blender}" -b "${opened[@]}" "${start[@]}" "$@" &
    trap 'kill $! 2>/dev/null' TERM
    wait $! || status=$?
    return "$status"
}

draw() { # FILE OUT FIRST LAST CHUNK
    local begin=$(($3 + SLURM_ARRAY_TASK_ID * $5)) end
    end=$((begin + $5 - 1))
    [ "$end" -le "$4" ] || end=$4
    illustrate "$1" -- --out="$2" --frames="$begin-$end" --format="${FORMATS:-svg,json}" \
        --warm-up="${WARM_UP:-2}" --expose-as="$3" --skip-existing --progress none
}

finish() { # FILE OUT INTO FIRST LAST LOGS JOB
    local errors
    errors=$(grep -h '^illustrate: error: ' "$6/$7"_*.log | sort -V)
    echo "${errors:-no errors in the logs of job $7}"
    illustrate -- merge "$2" --into="$3" --from="$1" --frames="$4-$5"
}

submit() { # FILE OUT INTO FIRST LAST [CHUNK]
    local chunk=${6:-10} logs=${LOGS:-$2/logs} drawn finished
    mkdir -p "$logs"
    drawn=$(sbatch --parsable --job-name=illustrate --requeue --open-mode=truncate \
        --output="$logs/%A_%a.log" --array="0-$((($5 - $4) / chunk))${MOST:+%$MOST}" \
        "$0" draw "$1" "$2" "$4" "$5" "$chunk")
    drawn=${drawn%%;*}
    finished=$(sbatch --parsable --job-name=illustrate-finish --requeue --open-mode=truncate \
        --output="$logs/%j.log" --dependency="afterany:$drawn" \
        "$0" finish "$1" "$2" "$3" "$4" "$5" "$logs" "$drawn")
    echo "draw $drawn"
    echo "finish ${finished%%;*}"
}

case ${1:-} in
    draw | finish) "$@" ;;
    *)
        [ $# -ge 5 ] || { sed -n '2,/^set/s/^# \?//p' "$0" >&2 && exit 2; }
        submit "$@"
        ;;
esac
