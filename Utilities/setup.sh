#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes everything ready on Debian 12: installs the packages that are missing, configures, and builds into
# build/release. What is done already is skipped. Needs to be root, or sudo, only when a package is missing.
set -eu

packages="g++ cmake ninja-build paraview-dev python3-paraview libeigen3-dev libopenmpi-dev xvfb"
source_folder=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build_folder=$source_folder/build/release

missing_packages() {
  for package in $packages; do
    # shellcheck disable=SC2016  # the dollar is for dpkg-query
    state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || printf ' %s' "$package"
  done
}

# Runs a command as root and quietly: its output is shown only when it fails.
as_root() {
  log=$(mktemp)
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@" >"$log" 2>&1 || status=$?
  elif command -v sudo >/dev/null 2>&1; then
    # shellcheck disable=SC2024  # the log is ours, not root's
    sudo env DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@" >"$log" 2>&1 || status=$?
  else
    echo "setup: installing packages needs root or sudo" >"$log"
    status=1
  fi
  if [ "${status:-0}" -ne 0 ]; then
    cat "$log" >&2
    rm -f "$log"
    echo "setup: failed: $*" >&2
    exit 1
  fi
  rm -f "$log"
}

install_packages() {
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  echo "setup: installing$missing (this takes some minutes the first time)"
  as_root apt-get update
  # shellcheck disable=SC2086  # one word per package
  as_root apt-get install -y --no-install-recommends $missing
}

build() {
  if [ ! -f "$build_folder/build.ninja" ]; then
    echo "setup: configuring in build/release"
    configure_log=$(mktemp)
    if ! cmake -S "$source_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=ON \
      >"$configure_log" 2>&1; then
      cat "$configure_log" >&2
      # A half-configured folder would look like a finished one the next time.
      rm -f "$build_folder/build.ninja" "$configure_log"
      echo "setup: configuring failed" >&2
      exit 1
    fi
    rm -f "$configure_log"
  fi
  echo "setup: building in build/release"
  # Ninja says little on its own when there is nothing to do, and shows a failing command with its messages.
  cmake --build "$build_folder" -- --quiet
}

install_packages
build
echo "setup: ready"
