#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Measures speed and memory of every stage, beside other programs: benchmark.sh [OPTION]... (see --help). Sets everything
# up first; a folder in the variable SEISMICHORIZONS_BUILD is taken as a build that is ready. Takes some minutes; figures
# are only worth something when the computer does nothing else.
set -eu

studies=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
utilities=$(dirname -- "$studies")
build_folder=${SEISMICHORIZONS_BUILD:-$(dirname -- "$utilities")/build/release}
python=/usr/bin/python3 # that of Debian, which has ParaView's modules
export PYTHONPATH="$build_folder/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"

case ${1:-} in
  -h | --help) exec "$python" "$studies/benchmark.py" --help ;;
esac
if [ -z "${SEISMICHORIZONS_BUILD:-}" ]; then
  "$utilities/setup.sh" >&2
  # The program that has CGAL exists where that was found.
  for program in BoundaryBenchmark ReadingBenchmark SurfaceDistanceBenchmark TriangulationBenchmark; do
    if ninja -C "$build_folder" -t query "$program" >/dev/null 2>&1; then
      cmake --build "$build_folder" --target "$program" -- --quiet >&2
    fi
  done
fi
exec "$python" "$studies/benchmark.py" "$build_folder/bin" "$@"
