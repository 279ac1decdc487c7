#!/usr/bin/env bash
# Draws the frames of a .blend as a Slurm array and merges them into keyframes (docs/farm.md).
#
#     illustrate.sh FILE.blend OUT INTO.blend FIRST LAST [CHUNK]
#
# Prints the numbers of the two jobs. In the environment: BLENDER, the program; SCRIPT, headless.py,
# for Blenders without the command of the extension; WARM_UP, frames drawn before each chunk;
# FORMATS, with json; MOST, tasks at a time; SBATCH_... as for every job.
set -eu

illustrate() { # ARGUMENTS: of Blender, then --, then of the command
    local opened=()
    while [ "$1" != -- ]; do
        opened+=("$1")
        shift
    done
    shift
    local start=(--command illustrate)
    [ -z "${SCRIPT:-}" ] || start=(--python-exit-code 3 --python "$SCRIPT" --)
    exec "${BLENDER:-blender}" -b "${opened[@]}" "${start[@]}" "$@"
}

draw() { # FILE OUT FIRST LAST CHUNK
    local begin=$SLURM_ARRAY_TASK_ID end
    end=$((begin + $5 - 1))
    [ "$end" -le "$4" ] || end=$4
    illustrate "$1" -- --out="$2" --frames="$begin-$end" --format="${FORMATS:-svg,json}" \
        --warm-up="${WARM_UP:-2}" --expose-as="$3" --skip-existing --progress none
}

merge() { # FILE OUT INTO FIRST LAST
    [ -e "$3" ] || cp "$1" "$3"
    illustrate -- merge "$2" --into "$3" --frames="$4-$5"
}

submit() { # FILE OUT INTO FIRST LAST [CHUNK]
    local chunk=${6:-10} drawn merged
    drawn=$(sbatch --parsable --job-name=illustrate --requeue \
        --array="$4-$5:$chunk${MOST:+%$MOST}" "$0" draw "$1" "$2" "$4" "$5" "$chunk")
    merged=$(sbatch --parsable --job-name=illustrate-merge --dependency="afterok:${drawn%%;*}" \
        --kill-on-invalid-dep=yes "$0" merge "$1" "$2" "$3" "$4" "$5")
    echo "draw ${drawn%%;*}"
    echo "merge ${merged%%;*}"
}

case ${1:-} in
    draw | merge) "$@" ;;
    *)
        [ $# -ge 5 ] || { sed -n '2,8s/^# \?//p' "$0" >&2 && exit 2; }
        submit "$@"
        ;;
esac
