# Sourced after common.sh: packages of Debian without installing them. Lists of packages are private
# copies, so that the machine's configuration stays as it is.

KEYRING=/usr/share/keyrings/debian-archive-keyring.gpg

has_checksum() { [ -f "$1" ] && echo "$2  $1" | sha256sum --check --status; }

# own_package_sources FOLDER: APT, for the sources of the packages of this machine's own Debian.
own_package_sources() {
    local list parts=$1/parts
    mkdir -p "$parts"
    for list in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
        [ -f "$list" ] && sed 's/^deb\([[:space:]]\)/deb-src\1/' "$list" >"$parts/${list##*/}.list"
    done
    for list in /etc/apt/sources.list.d/*.sources; do
        [ -f "$list" ] && sed 's/^Types:.*/Types: deb-src/' "$list" >"$parts/${list##*/}"
    done
    private_apt "$1"
}

# packages_of_suite deb|deb-src SUITE FOLDER: APT, for the packages of any Debian, or their sources.
packages_of_suite() {
    mkdir -p "$3/parts"
    echo "$1 [signed-by=$KEYRING check-valid-until=no] $(debian_mirror | sed 1q) $2 main" \
        >"$3/parts/suite.list"
    private_apt "$3"
}

# private_apt FOLDER: APT, the command that knows the lists of FOLDER/parts alone.
private_apt() {
    mkdir -p "$1/lists/partial"
    APT=(apt-get -qq -o APT::Sandbox::User= -o Dir::Etc::sourcelist=/dev/null
        -o "Dir::Etc::sourceparts=$1/parts" -o "Dir::State::lists=$1/lists"
        -o Dir::Cache::srcpkgcache= -o Dir::Cache::pkgcache=)
}
