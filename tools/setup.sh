#!/bin/bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Installs the packages of tools/packages.txt that are missing. Nothing is missing: nothing is done, without network.
set -euo pipefail
cd "$(dirname "$0")/.."

fail() {
    printf 'setup: %s\n' "$@" >&2
    exit 1
}

mapfile -t wanted < <(sed 's/#.*//' tools/packages.txt | awk 'NF { print $1 }')

if ! command -v dpkg-query > /dev/null || ! command -v apt-get > /dev/null; then
    echo "setup: not a Debian system, so nothing is installed; needed are the counterparts of: ${wanted[*]}" >&2
    exit 0
fi

installed=$(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "${wanted[@]}" 2> /dev/null |
    awk '$2 == "installed" { print $1 }' || true)
mapfile -t missing < <(printf '%s\n' "${wanted[@]}" | grep --line-regexp --invert-match --fixed-strings "$installed" || true)
[ "${#missing[@]}" -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo > /dev/null ||
        fail "packages are missing and this is neither root nor is there sudo. As root, run:" \
            "apt-get install --no-install-recommends ${missing[*]}"
    as_root=(sudo)
fi

mkdir -p build
log=build/setup.log
echo "setup: installing ${#missing[@]} packages: ${missing[*]}  (log: $log)"
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get --quiet --yes \
        -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "$@"
}
# One broken third-party source makes `update` fail; whether what we need can be had shows in `install`.
if ! { apt update || true; apt install --no-install-recommends "${missing[@]}"; } > "$log" 2>&1; then
    tail --lines=30 "$log" >&2
    fail "apt-get could not install the packages above: the end of $log is shown. Is the network there?"
fi
