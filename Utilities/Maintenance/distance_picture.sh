#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# distance_picture.sh PICTURE.png
#
# Draws the picture of the page on distances: a generated horizon, simplified in two ways. Needs the build in
# build/release.
set -eu

picture=${1:?usage: $0 PICTURE.png}
utilities=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
build=$(dirname -- "$utilities")/build/release
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
PYTHONPATH=$build/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}
export PYTHONPATH

"$build/bin/generate_horizons" --size 260 200 70 --horizons 1 --holes 3 --islands 0 --dropouts 0.005 \
  --squareness 0.6 "$folder/survey.vsm"
pvpython "$utilities/horizon_mesh.py" --no-pictures --output-folder "$folder/rough" --stages --cell-size 6 "$folder/survey.vsm"
pvpython "$utilities/horizon_mesh.py" --no-pictures --output-folder "$folder/elaborate" --stages --elaborate \
  "$folder/survey.vsm"
"$utilities/with-xvfb.sh" pvbatch "$utilities/show_error.py" --edges \
  --titles "Rough simplification, 6" "Rough simplification, 3, then elaborate" -- "$folder/survey.vsm" \
  "$folder/rough/survey_horizon_1.vtp" "$folder/elaborate/survey_horizon_1.vtp" "$picture"
