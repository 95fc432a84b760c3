#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# demo.sh [-o OUTPUT_FOLDER] [FILE.vsm]...
#
# Sets everything up, and turns the horizons of files (of the bundled sample without any) into meshes: one .vtp file
# per horizon, a picture of every stage, and a table. Results go to out/ in the current folder when no other is named.
# The sample has its time in ms and its place in the world, which files of this format do not say, and is cut at faults.
set -eu

usage="usage: $0 [-o OUTPUT_FOLDER] [FILE.vsm]..."
refuse() {
  printf 'demo: %s\n%s\n' "$1" "$usage" >&2
  exit 2
}

output=out
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help)
      echo "$usage"
      exit 0
      ;;
    -o | --output-folder)
      [ $# -ge 2 ] || refuse "no folder after $1"
      output=$2
      shift 2
      ;;
    --)
      shift
      break
      ;;
    -*) refuse "unknown option $1, expected -o or files" ;;
    *) break ;;
  esac
done
# All of this is told before the minutes that the setup takes.
for file in "$@"; do
  [ "$file" != -o ] || refuse "-o after a file, expected options before files"
  [ -f "$file" ] || refuse "no file $file"
  [ -r "$file" ] || refuse "$file cannot be read"
done
mkdir -p -- "$output" 2>/dev/null || refuse "the folder $output cannot be made"
[ -w "$output" ] || refuse "the folder $output cannot be written to"

utilities=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
source_folder=$(dirname -- "$utilities")
[ $# -gt 0 ] || set -- --z-from RealZ --origin 461200 6801500 0 --column-step 24 7 --row-step -7 24 --cut-faults 0 \
  "$source_folder/Data/sample.vsm"

"$utilities/setup.sh" --without-tests
PYTHONPATH=$source_folder/build/release/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH} \
  "$utilities/with-xvfb.sh" /usr/bin/python3 "$utilities/horizon_mesh.py" --output-folder "$output" "$@"
echo "demo: results are in $output"
