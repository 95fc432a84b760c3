#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# reproduce_thesis.sh [FOLDER [OPTION]...]
#
# Sets everything up, and writes the page Tables.md and its pictures into a folder, by default Documentation. The options
# are the same as for reproduce_thesis.py. The curves need the package python3-matplotlib, the programs compared in the thesis
# need meshlab, and CGAL needs libcgal-dev; missing ones are skipped. Takes a few minutes; times are meaningful only on an
# otherwise idle computer.
set -eu

studies=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
utilities=$(dirname -- "$studies")
source_folder=$(dirname -- "$utilities")
build_folder=$source_folder/build/release
output=${1:-$source_folder/Documentation}
[ $# -eq 0 ] || shift

"$utilities/setup.sh"
if ninja -C "$build_folder" -t query TriangulationBenchmark >/dev/null 2>&1; then
  cmake --build "$build_folder" --target TriangulationBenchmark -- --quiet
  set -- --triangulation-benchmark "$build_folder/bin/TriangulationBenchmark" "$@"
fi
PYTHONPATH=$build_folder/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH} \
  "$utilities/with-xvfb.sh" /usr/bin/python3 "$studies/reproduce_thesis.py" \
  "$build_folder/bin/generate_horizons" "$output" "$@"
echo "reproduce_thesis: the page is in $output"
