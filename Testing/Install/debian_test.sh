#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Debian packages on a fresh Debian 12: they install with apt, work with nothing set in the environment, and are
# removed without a trace. Arguments: the folder of the packages, the source tree, and a folder for the fresh root.
#
# Takes 3 GB and some minutes, root, debootstrap, and a mirror of Debian, so it runs on request alone:
#   SEISMICHORIZONS_TEST_PACKAGES=1
# SEISMICHORIZONS_DEBIAN_MIRROR names another mirror than that of debootstrap.
set -eu

packages=$1
source_folder=$2
root=$3
mirror=${SEISMICHORIZONS_DEBIAN_MIRROR:-}

skip() {
  echo "SKIPPED: $1"
  exit 77
}
[ "${SEISMICHORIZONS_TEST_PACKAGES:-0}" = 1 ] || skip "the packages were not tried; SEISMICHORIZONS_TEST_PACKAGES=1 does it"
[ "$(id -u)" -eq 0 ] || skip "a fresh root takes root"
command -v debootstrap > /dev/null || skip "debootstrap is not there"
ls "$packages"/seismichorizons_*.deb > /dev/null 2>&1 || skip "no packages in $packages; cmake --workflow --preset packages"

inside() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"
}
add() {
  inside apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends "$@" > /dev/null
}
remove() {
  inside apt-get purge -y -qq -o Dpkg::Use-Pty=0 "$@" > /dev/null
}
# Where a package lies inside, by the pattern of its name.
package() {
  printf '/packages/%s' "$(ls "$packages" | grep "^$1_")"
}
cleanup() {
  umount "$root/proc" 2> /dev/null || true
}
trap cleanup EXIT

step() {
  echo "== $1"
}
# All files but those that apt, dpkg and the interpreters keep for themselves.
list_files() {
  inside find / -xdev -path /proc -prune -o -path /tmp -prune -o -path /root -prune -o -path /var/lib/apt -prune -o \
    -path /var/cache -prune -o -path /var/log -prune -o -path '/var/lib/dpkg/*-old' -prune -o \
    -name __pycache__ -prune -o -path /etc/ld.so.cache -prune -o -path /packages -prune -o -print | sort
}

step "a fresh root"
[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$root" ${mirror:+"$mirror"} > "$root.log" 2>&1
mount -t proc proc "$root/proc"
rm -rf "$root/packages"
mkdir -p "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp -r "$source_folder/Data/sample.vsm" "$source_folder/Testing/Install" "$root/packages"
inside apt-get update -qq
# What the packages stand on comes first, so that what remains is of the packages alone.
add paraview paraview-dev python3-paraview xvfb xauth man-db g++ cmake ninja-build
remove seismichorizons python3-seismichorizons seismichorizons-doc 'libvtkseismichorizons*' 2> /dev/null || true # of a test before
list_files > "$root.before"

step "installing"
add "$(package seismichorizons)" "$(package python3-seismichorizons)" "$(package 'libvtkseismichorizons[0-9.]*')" \
  "$(package seismichorizons-doc)"
step "ParaView has the filters, in pvpython and in the window"
inside pvpython /packages/Install/debian_check.py /packages/sample.vsm
inside xvfb-run -a paraview --dr --exit --test-script=/packages/Install/debian_menu.xml
step "Python has the module"
inside /usr/bin/python3 -c 'import seismichorizons; print(seismichorizons.__version__)'
step "the command works, and has a manual page"
inside horizon-mesh --largest-error 1 --no-pictures --output-folder /tmp/out /packages/sample.vsm
[ "$(inside sh -c 'ls /tmp/out/*.vtp | wc -l')" -eq 2 ]
inside sh -c 'man horizon-mesh | grep -q -- --largest-error'
step "shells complete the command"
inside bash -c '. /usr/share/bash-completion/completions/horizon-mesh && complete -p horizon-mesh' > /dev/null
inside grep -q -- --largest-error /usr/share/zsh/site-functions/_horizon-mesh

step "the commands on the pages do what they say"
inside xvfb-run -a /usr/bin/python3 /packages/Install/pages_check.py /usr/share/doc/seismichorizons /tmp/pages

step "another project finds the module"
add "$(package libvtkseismichorizons-dev)"
inside sh -c 'cmake -G Ninja -S /packages/Install/Consumer -B /tmp/consumer && ninja -C /tmp/consumer &&
  /tmp/consumer/consumer /packages/sample.vsm'
remove libvtkseismichorizons-dev

step "removing"
remove seismichorizons python3-seismichorizons seismichorizons-doc 'libvtkseismichorizons0*'
list_files > "$root.after"
if ! diff "$root.before" "$root.after"; then
  echo "the packages left the above behind" >&2
  exit 1
fi
