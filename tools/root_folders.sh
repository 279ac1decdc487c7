# Sourced after common.sh: root folders of Debian, and how this machine's registries are reached
# from within them.

# registry_settings FOLDER: where this machine gets packages from, and whom it trusts.
registry_settings() {
    local root=$1 path in_root
    rm -rf "$root/etc/apt/sources.list" "$root"/etc/apt/sources.list.d/*
    for path in /etc/apt/sources.list /etc/apt/sources.list.d/*.list \
        /etc/apt/sources.list.d/*.sources; do
        copy_to_root "$path" "$root"
    done
    python_registry_settings "$root"
}

# python_registry_settings FOLDER: the same without the list of Debian's packages.
python_registry_settings() {
    local root=$1 path
    for path in /etc/apt/auth.conf /etc/apt/auth.conf.d \
        $(grep -ls '^ *Acquire::' /etc/apt/apt.conf /etc/apt/apt.conf.d/*) \
        /etc/resolv.conf /etc/hosts /usr/local/share/ca-certificates \
        /etc/pip.conf "$HOME/.config/pip" "$HOME/.pip" "$HOME/.netrc"; do
        copy_to_root "$path" "$root"
    done
    mkdir -p "$root/etc/ssl/certs"
    cp -L /etc/ssl/certs/ca-certificates.crt "$root/etc/ssl/certs/"
}

# copy_to_root PATH FOLDER: to the same place in there, if it is here; of the home, to root's.
copy_to_root() {
    local in_root=$2${1/#$HOME//root}
    [ -e "$1" ] || return 0
    mkdir -p "$(dirname "$in_root")"
    rm -rf "$in_root"
    cp -RL "$1" "$in_root"
}

# registry_variables: those of the environment that say how registries are reached.
registry_variables() {
    env | grep -E '^(PIP_[A-Z_]*|SSL_CERT_[A-Z]*|REQUESTS_CA_BUNDLE|CURL_CA_BUNDLE|[a-z]+_proxy|[A-Z]+_PROXY)=' ||
        true
}
