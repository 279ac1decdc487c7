#!/bin/sh
# enter_root.sh FOLDER COMMAND...: runs a command with FOLDER as /, and with /proc where that is
# allowed. What is mounted is seen by the command alone and gone with it.
exec unshare --mount sh -c '
    root=$1
    shift
    mount -t proc proc "$root/proc" || echo "no /proc in $root" >&2
    exec chroot "$root" "$@"
' sh "$@"
