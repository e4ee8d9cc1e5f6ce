# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# What packaging/run and packaging/test share: installing what is missing, configuring, building.
# Meant to be sourced from bash with `set -euo pipefail`.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }
stop() { say "$*"; exit 1; }

as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        stop "Installing packages needs root, and there is no sudo. Run this as root: $*"
    fi
}

# wanted <list> <purpose>...: the packages of a list for these purposes, one per line.
wanted() {
    local list=$1 purpose
    shift
    for purpose in "$@"; do
        awk -v purpose="$purpose" '$1 == purpose { print $2 }' "$root/packaging/dependencies/$list"
    done
}

# A library that was rebuilt for 64-bit times (Ubuntu 24.04, Debian 13) has t64 behind its name.
debian_installed() {
    { dpkg-query -W -f '${db:Status-Status}\n' "$1" "$1t64" 2>/dev/null || true; } |
        grep -qx installed
}

debian_missing() {
    local entry name
    wanted debian.txt "$@" | while read -r entry; do
        for name in ${entry//|/ }; do
            if debian_installed "$name"; then
                continue 2
            fi
        done
        printf '%s\n' "$entry"
    done
}

# The first of first|second that the package index knows.
debian_name() {
    local name
    for name in ${1//|/ }; do
        if apt-cache show "$name" >/dev/null 2>&1; then
            printf '%s\n' "$name"
            return
        fi
    done
    printf '%s\n' "${1%%|*}"
}

debian_install() {
    local entry names=()
    say "Installing: $(tr '\n' ' ' <<<"$1")"
    as_root apt-get update -q
    while read -r entry; do
        names+=("$(debian_name "$entry")")
    done <<<"$1"
    as_root env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y -q --no-install-recommends "${names[@]}"
}

# install_missing <purpose>...: purposes are build, run, test, benchmark.
install_missing() {
    local missing
    if command -v apt-get >/dev/null; then
        missing=$(debian_missing "$@")
        [ -z "$missing" ] || debian_install "$missing"
    elif command -v dnf >/dev/null; then
        missing=$(wanted fedora.txt "$@" | while read -r name; do
            rpm -q --whatprovides "$name" >/dev/null 2>&1 || printf '%s\n' "$name"
        done)
        # shellcheck disable=SC2086
        [ -z "$missing" ] || as_root dnf install -y --setopt=install_weak_deps=False $missing
    elif command -v pacman >/dev/null; then
        missing=$(wanted arch.txt "$@" | xargs pacman -T || true)
        # shellcheck disable=SC2086
        [ -z "$missing" ] || as_root pacman -S --needed --noconfirm $missing
    else
        say "This system has none of apt-get, dnf and pacman. Patina needs these, under Debian's names:"
        wanted debian.txt "$@" | sed 's/^/  /' >&2
        stop "Install them, then build with: cmake --preset release && cmake --build --preset release"
    fi
}

# build <preset> [target...]
build() {
    local preset=$1 targets=()
    shift
    if [ ! -f "$root/build/$preset/build.ninja" ]; then
        (cd "$root" && cmake --preset "$preset" >&2)
    fi
    [ $# -eq 0 ] || targets=(--target "$@")
    (cd "$root" && cmake --build --preset "$preset" --parallel "$(nproc)" "${targets[@]}" >&2)
}
