# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours of pictures and reports, as six hexadecimal digits."""

LOW_TO_HIGH = ("440154", "482878", "3e4989", "31688e", "26828e", "1f9e89", "35b779", "6ece58", "b5de2b", "fde725")
LEVEL_COLORS = ("1d4e89", "2a9d8f", "e9a23b", "c1121f", "6a0d83", "333333")
NEAR_TO_FAR = ((0.0, "f4f2ea"), (0.12, "fee090"), (0.3, "fdae61"), (0.5, "e9693e"), (0.72, "b72842"), (1.0, "4a0c4a"))
LAYER_COLORS = ("edc97a", "cc8052", "8cb06b", "5c94ad", "73618f", "9e9ea3")
# Colours of triangles that close faults, next to colours of heights and of distances.
FAULT_COLOR, FAULT_COLOR_BY_DISTANCE = "cc6b4d", "8fa3b5"


def rgb(color):
    """Returns red, green and blue from 0 to 1 for a colour of six hexadecimal digits."""
    return tuple(int(color[i:i + 2], 16) / 255.0 for i in (0, 2, 4))
