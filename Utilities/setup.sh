#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes everything ready on Debian 12: installs the packages that are missing, configures, and builds into
# build/release. --without-tests leaves out what only the tests and the site of the documentation take, --without-paraview
# also ParaView: the Python package and its command remain. --only-packages builds nothing. What is done already is
# skipped. Needs to be root, or sudo, only when a package is missing.
set -eu

packages="g++ cmake ninja-build libeigen3-dev zlib1g-dev libpython3-dev python3-numpy python3-pip"
# libqt5svg5 draws the icons of ParaView's window, the qt tools make the pages of its help.
packages_of_paraview="paraview-dev python3-paraview libopenmpi-dev libqt5svg5 qttools5-dev qtxmlpatterns5-dev-tools xvfb"
# mkdocs-material and doxygen make the site of the documentation.
# dpkg-dev and file find out what the Debian packages depend on.
# codespell checks the spelling of the pages.
packages_of_tests="mkdocs-material doxygen xdotool dpkg-dev file codespell"
with_tests=ON
without_paraview=OFF
with_build=yes
python=${PYTHON:-/usr/bin/python3}
source_folder=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build_folder=$source_folder/build/release
log=$(mktemp)
ticker=
cleanup() {
  [ -z "$ticker" ] || kill -KILL "$ticker" 2>/dev/null || true
  rm -f "$log"
}
trap cleanup EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

fail() {
  echo "setup: $1" >&2
  exit 1
}

for option in "$@"; do
  case $option in
    --without-tests) with_tests=OFF ;;
    --without-paraview) with_tests=OFF without_paraview=ON ;;
    --only-packages) with_build=no ;;
    *) fail "unknown option $option, expected --without-tests, --without-paraview or --only-packages" ;;
  esac
done
[ "$without_paraview" = ON ] || packages="$packages $packages_of_paraview"
[ "$with_tests" = OFF ] || packages="$packages $packages_of_tests"

# Says every now and then that work goes on.
say_still() {
  seconds=0
  while sleep 20 >/dev/null 2>&1; do # which goes on a little after the rest, and would keep a pipe open
    seconds=$((seconds + 20))
    echo "setup: still $1$(sed -n 's,^\[\([0-9]*\)/\([0-9]*\)\].*,\, \1 of \2 steps,p' "$log" | tail -n 1) ($seconds s)"
  done
}

# quietly WHAT COMMAND...: runs a command whose output is shown only when it fails.
quietly() {
  say_still "$1" &
  ticker=$!
  shift
  status=0
  "$@" >"$log" 2>&1 || status=$?
  kill -KILL "$ticker" 2>/dev/null || true # a shell that has just begun may miss other signals
  wait "$ticker" 2>/dev/null || true
  ticker=
  return "$status"
}

missing_packages() {
  for package in $packages; do
    # shellcheck disable=SC2016  # the dollar is for dpkg-query
    state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$state" = installed ] || printf ' %s' "$package"
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    env DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"
  else
    sudo env DEBIAN_FRONTEND=noninteractive LC_ALL=C "$@"
  fi
}

# Where no package list can be had, apt-get only complains that it knows no such package.
require_package_lists() {
  for package in $1; do
    apt-cache show "$package" >/dev/null 2>&1 ||
      fail "no package lists with $package, expected those of Debian 12: is the network there?"
  done
}

# How many packages come, with those that they need themselves, and how large they are.
say_size() {
  # shellcheck disable=SC2086  # one word per package
  LC_ALL=C apt-get install --assume-no --no-install-recommends $1 >"$log" 2>&1 || true
  count=$(sed -n 's/.* \([0-9]*\) newly installed.*/\1/p' "$log")
  download=$(sed -n 's/^Need to get \(.*\) of archives.*/\1/p' "$log")
  disk=$(sed -n 's/^After this operation, \(.*\) of additional.*/\1/p' "$log")
  echo "setup: installing$1"
  [ -z "$count" ] ||
    echo "setup: $count packages with what they need, ${download:-nothing} to download, ${disk:-nothing} on disk; some minutes"
}

install_packages() {
  missing=$(missing_packages)
  [ -n "$missing" ] || return 0
  [ "$(id -u)" -eq 0 ] || command -v sudo >/dev/null 2>&1 ||
    fail "installing$missing needs root or sudo"
  [ "$(id -u)" -eq 0 ] || sudo -v || fail "installing$missing needs root or sudo"
  quietly "fetching package lists" as_root apt-get update || true
  require_package_lists "$missing"
  say_size "$missing"
  # shellcheck disable=SC2086  # one word per package
  if ! quietly "installing packages" as_root apt-get install -y --no-install-recommends $missing; then
    cat "$log" >&2
    fail "installing$missing failed"
  fi
}

# Binds the methods for Python. Debian 12 has no package of it; PyPI has.
fetch_nanobind() {
  [ ! -d "$source_folder/build/nanobind/nanobind" ] || return 0
  ! "$python" -m nanobind --cmake_dir >/dev/null 2>&1 || return 0
  echo "setup: fetching nanobind from PyPI into build/nanobind"
  if ! quietly "fetching nanobind" "$python" -m pip install --no-deps --target "$source_folder/build/nanobind" "nanobind>=2.4"; then
    cat "$log" >&2
    rm -rf "$source_folder/build/nanobind"
    fail "no nanobind from PyPI, expected it for the Python package: is the network there?"
  fi
}

# Files that are compiled several at a time take half as long.
configure() {
  echo "setup: configuring in build/release"
  if ! quietly "configuring" cmake -S "$source_folder" -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_UNITY_BUILD=ON -DBUILD_TESTING="$with_tests" -DSEISMICHORIZONS_METHODS_ONLY="$without_paraview"; then
    cat "$log" >&2
    # A half-configured folder would look like a finished one the next time.
    rm -f "$build_folder/build.ninja"
    fail "configuring failed"
  fi
}

# A build with tests, or with ParaView, also has all that one without them has.
is_configured() {
  [ -f "$build_folder/build.ninja" ] &&
    { [ "$with_tests" = OFF ] || grep -q '^BUILD_TESTING:BOOL=ON$' "$build_folder/CMakeCache.txt"; } &&
    { [ "$without_paraview" = ON ] || grep -q '^SEISMICHORIZONS_METHODS_ONLY:BOOL=OFF$' "$build_folder/CMakeCache.txt"; }
}

# The Python package takes 350 seconds of one processor, and ParaView's part, which compiles none of it again, 155.
say_duration() {
  seconds=0
  ls "$build_folder"/lib/python3/dist-packages/seismichorizons/_core.*.so >/dev/null 2>&1 || seconds=350
  [ "$without_paraview" = ON ] || seconds=$((seconds + 155))
  processors=$(nproc)
  if [ "$with_tests" = ON ]; then
    echo "some minutes"
  else
    echo "about $((seconds / processors / 60 + 1)) min (processors: $processors)"
  fi
}

build() {
  duration=
  if ! is_configured; then
    duration=", $(say_duration)"
    configure
  fi
  echo "setup: building in build/release$duration"
  if ! quietly "building" cmake --build "$build_folder"; then
    grep -v '^\[' "$log" >&2 || true
    fail "building failed"
  fi
}

install_packages
fetch_nanobind
[ "$with_build" = yes ] || exit 0
build
echo "setup: ready"
