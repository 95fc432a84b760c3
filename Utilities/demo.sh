#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# demo.sh [-o OUTPUT_FOLDER] [FILE.vsm]...
#
# Sets everything up, and turns the horizons of files (of the bundled sample without any) into meshes: one .vtp file
# per horizon, a table, a report, and where VTK is there a picture of every stage. Results go to out/ in the current folder
# when no other is named.
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
if [ $# -eq 0 ]; then
  file=$source_folder/Data/sample.vsm
  set -- --z-from RealZ --origin 461200 6801500 0 --column-step 24 7 --row-step -7 24 --cut-faults 0 "$file"
fi

"$utilities/setup.sh" --without-paraview
build_folder=$source_folder/build/release
export PYTHONPATH="$build_folder/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"
# Pictures need VTK, which comes with ParaView, and mostly an X server. The report has meshes without them.
screen=$utilities/with-xvfb.sh
command -v Xvfb >/dev/null 2>&1 || screen=env
can_draw="from seismichorizons_command import batch; raise SystemExit(batch.why_no_pictures() is not None)"
"$screen" /usr/bin/python3 -c "$can_draw" >/dev/null 2>&1 || set -- --no-pictures "$@"
set -- --output-folder "$output" --report "$output/report.html" "$@"
echo "demo: horizon-mesh $*"
"$screen" /usr/bin/python3 "$utilities/horizon_mesh.py" "$@"

echo "demo: the report is $output/report.html: open it in a browser and drag its meshes to rotate them"
set -- "$output"/*.png
[ ! -e "$1" ] || echo "demo: the pictures are $output/*.png"
plugins=$(echo "$build_folder"/lib/paraview-*/plugins)
if [ -e "$plugins/SeismicHorizons/SeismicHorizons.so" ]; then
  echo "demo: the window: PV_PLUGIN_PATH=$plugins paraview $file"
else
  echo "demo: for the window of ParaView, and pictures: $utilities/setup.sh --without-tests, then this command again"
fi
