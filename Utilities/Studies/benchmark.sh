#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures speed and memory of every stage and of other programs: benchmark.sh [OPTION]... (see --help). Sets everything up
# first; if the variable SEISMICHORIZONS_BUILD is set, it is the folder of a finished build. Takes a few minutes; the figures
# are meaningful only on an otherwise idle computer.
set -eu

studies=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
utilities=$(dirname -- "$studies")
build_folder=${SEISMICHORIZONS_BUILD:-$(dirname -- "$utilities")/build/release}
python=/usr/bin/python3 # Debian's Python, which has ParaView's modules
export PYTHONPATH="$build_folder/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"

case ${1:-} in
  -h | --help) exec "$python" "$studies/benchmark.py" --help ;;
esac
if [ -z "${SEISMICHORIZONS_BUILD:-}" ]; then
  "$utilities/setup.sh" >&2
  # The CGAL program exists only if CGAL was found.
  for program in BoundaryBenchmark ReadingBenchmark ScalingBenchmark SurfaceDistanceBenchmark TriangulationBenchmark; do
    if ninja -C "$build_folder" -t query "$program" >/dev/null 2>&1; then
      cmake --build "$build_folder" --target "$program" -- --quiet >&2
    fi
  done
fi
exec "$python" "$studies/benchmark.py" "$build_folder/bin" "$@"
