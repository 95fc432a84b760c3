#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# demo.sh [FILE.vsm] [OUTPUT_FOLDER]
#
# Sets everything up, and turns the horizons of a file (the sample without one) into meshes: one .vtp file per
# horizon, a picture of every stage, and a table. Results go to out/ in the source tree when no folder is named.
set -eu

case ${1:-} in
  -h | --help)
    echo "usage: $0 [FILE.vsm] [OUTPUT_FOLDER]"
    exit 0
    ;;
esac

utilities=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
source_folder=$(dirname -- "$utilities")
file=${1:-$source_folder/Data/sample.vsm}
output=${2:-$source_folder/out}

"$utilities/setup.sh"
PYTHONPATH=$source_folder/build/release/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH} \
  "$utilities/with-xvfb.sh" pvbatch "$utilities/horizon_mesh.py" --output-folder "$output" "$file"
echo "demo: results are in $output"
