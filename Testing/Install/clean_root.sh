#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# The commands of the README on a fresh Debian 12 with nothing else installed: a clone of the last commit, the demo, all
# tests, and the demo with pictures, which need ParaView. Argument: a folder for the root (12 GB), which is made by debootstrap unless it is there. Takes root, a mirror
# of Debian and half an hour; SEISMICHORIZONS_DEBIAN_MIRROR names another mirror than that of debootstrap.
set -eu

[ $# -eq 1 ] || { echo "usage: $0 FOLDER" >&2; exit 2; }
root=$1
mirror=${SEISMICHORIZONS_DEBIAN_MIRROR:-}
source_folder=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)

inside() {
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"
}
cleanup() {
  umount "$root/dev/shm" "$root/dev/pts" "$root/sys" "$root/proc" 2> /dev/null || true
}
trap cleanup EXIT

[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$root" ${mirror:+"$mirror"} > "$root.log"
cleanup # of a run that was killed
mount -t proc proc "$root/proc"
mount -t sysfs sysfs "$root/sys" # Open MPI looks there
mount -t devpts devpts "$root/dev/pts"
mount -t tmpfs tmpfs "$root/dev/shm"
rm -rf "$root/project"
git clone --quiet --no-hardlinks "$source_folder" "$root/project"
inside sh -c 'cd && /project/Utilities/demo.sh && ls out/report.html out/sample_horizon_?.vtp'
inside sh -c 'cd && /project/Utilities/test.sh'
inside sh -c 'cd && /project/Utilities/demo.sh -o results /project/Data/sample.vsm && ls results/sample.png'
