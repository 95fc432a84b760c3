#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws the pictures of Documentation/Parameters.md. Needs an X server, the plugin in PV_PLUGIN_PATH, and ImageMagick.
set -eu

tree=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$tree/build/release/bin/generate_horizons" --size 160 160 60 --horizons 1 --holes 10 --dropouts 0.05 --noise 0.2 \
  --noise-gaps 0.6 "$work/horizon.vsm"

# draw NAME ARGUMENTS...: the arguments of side_by_side.py after the two files.
draw() {
  name=$1
  shift
  pvbatch "$tree/Utilities/Recipes/side_by_side.py" "$work/horizon.vsm" "$work/$name.png" "$@"
  convert "$work/$name.png" -colors 64 "$tree/Documentation/Pictures/$name.png"
}
draw ChooseError MaximumError 0.5 1.5 8
draw ChooseRadius --from-above Radius 1 2 8
draw ChooseHoles --from-above SmallestHoleSize 1 20 2000
