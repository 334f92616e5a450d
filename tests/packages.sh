# Sourced by tests/run.sh and samples/demo.sh: install the Debian packages that are missing.
# install_packages LIST PURPOSE...: those of LIST (packages.txt) for these purposes; asks for nothing that is there.

is_installed() { dpkg-query -W -f '${Status}' "$1" 2>/dev/null | grep -q '^install ok installed$'; }

as_root() {
    if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

install_packages() {
    list=$1
    shift
    missing=
    for purpose in "$@"; do
        # shellcheck disable=SC2013 # names have no spaces
        for package in $(awk -v purpose="$purpose" '$1 == purpose { print $2 }' "$list"); do
            is_installed "$package" || missing="$missing $package"
        done
    done
    [ -n "$missing" ] || return 0
    echo "Debian packages that are missing:$missing" >&2
    if ! command -v apt-get >/dev/null; then
        echo "There is no apt-get here. Please install them in your system's way; Debian 12 is what we test on." >&2
        return 1
    fi
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        echo "Installing needs root, and there is no sudo here. As root, please run:" >&2
        echo "  apt-get update && apt-get install -y --no-install-recommends$missing" >&2
        return 1
    fi
    # a broken foreign source must not stop us: whether the packages are to be had, the install says
    as_root apt-get update -q >&2 || echo "apt-get update had a complaint; trying the install all the same" >&2
    # shellcheck disable=SC2086 # several words
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing >&2 || {
        echo "The packages could not be installed; apt-get says why above." >&2
        return 1
    }
}
