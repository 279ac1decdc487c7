#!/usr/bin/env bash
# Runs the README's commands where nothing was ever installed: a clone of the committed tree in a
# bare root folder of Debian 12, which holds make, git, certificates and this machine's registry
# settings besides what debootstrap's smallest variant has.
#
# fresh.sh                     demo and test, in this order and in the other, each order in a root
#                              of its own, then test with the shared folder, read-only
# fresh.sh [--shared] TARGET... one root, these targets, one after another; prints all they say
# fresh.sh --check             only whether this machine can do that; exit 1 and the reason if not
#
# Roots are removed at the end, also after a failure or a signal. In the cache stay the packed bare
# root and downloads (Debian's packages, Python's wheels, source archives); nothing installed or
# built. Needs root, debootstrap and the registries.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
source "$ROOT/tools/root_folders.sh"

SUITE=bookworm
DOWNLOADS=$CACHE/downloads
SHARED=${ILLUSTRATE_SHARED:-$ROOT/../shared}
LOGS=$ROOT/build/fresh
CHECKOUT=srv/illustrate/main
CLOSING_LINES=12

cannot() {
    say "cannot run in a bare root: $*"
    exit 1
}

registry_answers() {
    local release answer=0
    release=$(mktemp)
    /usr/lib/apt/apt-helper -qq download-file "$(debian_mirror | sed 1q)/dists/$SUITE/Release" \
        "$release" >/dev/null 2>&1 || answer=1
    rm -f "$release"
    return "$answer"
}

check() {
    [ "$(id -u)" = 0 ] || cannot "only root can make one: run this as root (sudo make fresh)"
    command -v unshare >/dev/null || cannot "there is no unshare (package util-linux)"
    unshare --mount --pid --fork true 2>/dev/null ||
        cannot "this system does not let root mount anything (a container needs --privileged)"
    [ -n "$(debian_mirror)" ] || cannot "/etc/apt names no registry of Debian's packages"
    "$ROOT/tools/setup_system.sh" root >&2 || cannot "debootstrap could not be installed"
    registry_answers || cannot "the registry of Debian's packages does not answer"
}

# --- The bare root ---

# bare_root FOLDER: debootstrap's smallest variant with what a checkout needs.
bare_root() {
    debootstrap --variant=minbase --include=ca-certificates,git,make "$SUITE" "$1" \
        "$(debian_mirror | sed 1q)" && rm -f "$1"/var/cache/apt/archives/*.deb
}

# packed_root: the archive of a bare root in the cache.
packed_root() {
    local archive=$CACHE/bare-$SUITE.tar
    if [ ! -f "$archive" ]; then
        say "making a bare root of Debian $SUITE (once)" >&2
        local work
        work=$(mktemp -d "$CACHE/bare.XXXXXX")
        trap "rm -rf '$work'" RETURN
        bare_root "$work/root" >"$archive.log" 2>&1 || fail "that failed: see $archive.log"
        tar -C "$work/root" -cf "$work/packed" .
        mv "$work/packed" "$archive"
    fi
    printf '%s\n' "$archive"
}

# remove_stale: roots whose makers were killed before they could.
remove_stale() {
    local lock
    for lock in "$CACHE"/fresh.*.lock; do
        [ -e "$lock" ] || continue
        flock --nonblock "$lock" rm -rf --one-file-system "${lock%.lock}" "$lock" || true
    done
}

remove_root() {
    if [ -n "$JOB" ]; then
        # unshare itself hears nothing softer.
        kill -KILL "$JOB" 2>/dev/null && wait "$JOB" 2>/dev/null || true
    fi
    [ -z "${ROOTFS:-}" ] || rm -rf --one-file-system "$ROOTFS" "$ROOTFS.lock"
    ROOTFS=
}

# new_root: ROOTFS, unpacked, with the clone.
new_root() {
    remove_root
    ROOTFS=$(mktemp -d "$CACHE/fresh.XXXXXX")
    exec 7>"$ROOTFS.lock"
    flock 7
    tar -C "$ROOTFS" -xf "$(packed_root)"
    registry_settings "$ROOTFS"
    git clone --quiet --no-hardlinks "$ROOT" "$ROOTFS/$CHECKOUT"
}

# --- In it ---

# enter SHARED TARGET: make TARGET in the root's clone, in place of this process. What is mounted is
# seen by it alone and gone with it; so is whatever it leaves running. SHARED: a folder to show
# beside the clone, or nothing.
enter() {
    mkdir -p "$DOWNLOADS"/{packages/partial,wheels,sources}
    rm -rf "$DOWNLOADS/wheels/wheels" # what pip built itself
    local variables
    mapfile -t variables < <(registry_variables)
    exec unshare --mount --pid --fork --kill-child=KILL bash -c '
        set -e
        root=$1 downloads=$2 checkout=$3 shared=$4
        shift 4
        mount --make-rprivate /
        mount --bind "$root" "$root" # / in there is a mount, as mounting in there asks for
        mount -t proc proc "$root/proc"
        mount -t sysfs -o ro sysfs "$root/sys"
        mount -t tmpfs tmpfs "$root/dev"
        for node in null zero full random urandom tty; do
            : >"$root/dev/$node" && mount --bind "/dev/$node" "$root/dev/$node"
        done
        mkdir "$root/dev/shm" && mount -t tmpfs tmpfs "$root/dev/shm"
        ln -s /proc/self/fd "$root/dev/fd"
        cache=$root/root/.cache
        mkdir -p "$cache/pip" "$cache/illustrate/sources"
        mount --bind "$downloads/packages" "$root/var/cache/apt/archives"
        mount --bind "$downloads/wheels" "$cache/pip"
        mount --bind "$downloads/sources" "$cache/illustrate/sources"
        if [ -n "$shared" ]; then
            mkdir -p "$root/$checkout/../shared"
            mount --bind -o ro "$shared" "$root/$checkout/../shared"
        fi
        chroot "$root" /usr/bin/env -i HOME=/root LANG=C.UTF-8 \
            PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
    ' bash "$ROOTFS" "$DOWNLOADS" "$CHECKOUT" "$1" "${variables[@]}" \
        ${CI:+CI=$CI} make --no-print-directory -C "/$CHECKOUT" "$2" 7>&- </dev/null
}

# attend SHARED TARGET: enters beside this script, so that a signal to it is heard at once.
attend() {
    local status=0
    (enter "$@") 2>&1 &
    JOB=$!
    wait "$JOB" || status=$?
    JOB=
    return "$status"
}

# run NAME SHARED TARGET: attends, keeps the log, prints the closing lines, the time and the result.
run() {
    local log=$LOGS/${1//[^a-z]/-}-$3.log start=$SECONDS status=0
    printf '\n== make %s, %s\n' "$3" "$1"
    attend "$2" "$3" >"$log" || status=$?
    tail -n "$CLOSING_LINES" "$log"
    report "$3" "$status" "$((SECONDS - start))"
}

report() {
    local result=passed
    [ "$2" = 0 ] || result="FAILED with exit code $2"
    say "make $1 in a bare root $result after $(($3 / 60)) min $(($3 % 60)) s"
    return "$2"
}

both_orders() {
    local status=0
    new_root
    run "in a new root" "" demo || status=1
    run "after demo" "" test || status=1
    new_root
    run "in a new root" "" test || status=1
    run "after test" "" demo || status=1
    if [ -d "$SHARED" ]; then
        run "with the shared folder" "$SHARED" test || status=1
    else
        say "left out, there is no shared folder at $SHARED: the tests that need it"
    fi
    return "$status"
}

# these TARGET...: with all that they print.
these() {
    local status=0 target start shared=
    [ -z "$with_shared" ] || [ ! -d "$SHARED" ] || shared=$SHARED
    new_root
    for target in "$@"; do
        start=$SECONDS
        attend "$shared" "$target" || status=$?
        report "$target" "$status" "$((SECONDS - start))" || break
    done
    return "$status"
}

JOB=
with_shared=
case ${1:-} in
    --check) check && exit ;;
    --shared) with_shared=1 && shift ;;
esac
check
mkdir -p "$CACHE" "$LOGS"
SHARED=$(readlink -f "$SHARED")
[ -z "$(git -C "$ROOT" status --porcelain)" ] || say "what is not committed is not in the clone"
remove_stale
trap 'remove_root' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM HUP
if [ $# = 0 ]; then both_orders; else these "$@"; fi
