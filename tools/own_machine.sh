#!/usr/bin/env bash
# own_machine.sh COMMAND...: runs a command with processes, mounts, an empty /run and a loopback of
# its own. Whatever it started or mounted is gone at its end, also when this script is ended, however
# that is done. Needs root.
set -eu

JOB=
end() {
    [ -z "$JOB" ] || { kill -KILL "$JOB" && wait "$JOB"; } 2>/dev/null || true
}
trap end EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP

# The address that is not 127.0.0.1: where that is the only one, getaddrinfo() does not know it.
setpriv --pdeathsig KILL unshare --mount --propagation private --pid --mount-proc --net --fork \
    --kill-child=KILL bash -c '
        set -e
        mount --make-rshared /
        mount -t tmpfs tmpfs /run
        ip link set lo up
        ip address add 192.0.2.1/32 dev lo
        "$@"
        exit 0
    ' bash "$@" &
JOB=$!
status=0
wait "$JOB" || status=$?
JOB=
exit "$status"
