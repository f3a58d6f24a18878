#!/bin/sh
# install_packages.sh LIST...: installs those Debian packages of the lists (one a line) that this machine lacks. Of a line
# a|b either will do; where both are missing it is a.
# When nothing is missing it asks no network. Exits 2, naming the packages and the command, when it cannot install.
set -eu

wanted=$(cat "$@" | sed 's/#.*//')

if ! command -v dpkg-query >/dev/null; then
    echo "Trocar's Makefile installs what it needs on Debian 12, and this is no Debian: dpkg-query is missing." >&2
    echo "Install what $* names, then run: cmake --preset release && cmake --build --preset release" >&2
    exit 2
fi

is_installed() {
    [ "$(dpkg-query --show --showformat '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

missing=
for line in $wanted; do
    for package in $(echo "$line" | tr '|' ' '); do
        if is_installed "$package"; then continue 2; fi
    done
    missing="$missing ${line%%|*}"
done
[ -n "$missing" ] || exit 0

as_root=
[ "$(id -u)" = 0 ] || as_root=sudo
apt="$as_root env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300"

# A package list that cannot be refreshed is no reason to stop: the one at hand may do.
echo "Installing the Debian packages that are missing:$missing"
if { [ -z "$as_root" ] || command -v sudo >/dev/null; } &&
    { $apt update || true; } && $apt install -y --no-install-recommends $missing; then
    exit 0
fi

echo >&2
echo "These Debian packages are missing and could not be installed:$missing" >&2
echo "Run this as root, then try again:" >&2
echo "    apt-get update && apt-get install -y --no-install-recommends$missing" >&2
exit 2
