#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the picture of the page on cutoffs: three horizons cut by a fault that dies out, in section, on the map, and along the
fault.

    cutoff_pictures.py FOLDER

Needs matplotlib, and the package seismichorizons in PYTHONPATH.
"""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
import seismichorizons as sh  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

BIN, SIZE, NOISE = 25.0, 120, 1.0
NAMES, DEPTHS = ("Top", "Middle", "Base"), (1000.0, 1130.0, 1300.0)
COLORS = ("#edc97a", "#cc8052", "#8cb06b", "#5c94ad", "#736194", "#bfbfc4", "#b3404d", "#4d6b4d", "#d99eb8", "#334d73")
FOOT, HANGING, GREY = "#cc4019", "#1940b3", "#666666"
ROW = 60  # of the section


def fault_x(y, depth):
    return 1300.0 + 0.12 * y + 60.0 * np.sin(y / 500.0) + 0.55 * (depth - 1100.0) + 2e-4 * (depth - 1100.0) ** 2


def throw(y, depth):
    return (90.0 + 0.1 * (depth - 1000.0)) * np.clip(1.0 - ((y - 1250.0) / 1350.0) ** 2, 0.0, None)


def make_horizon(name, depth):
    """Picks of both walls. Trackers go on for two columns on the wrong side."""
    x, y = np.meshgrid(np.arange(SIZE) * BIN, np.arange(SIZE) * BIN)
    foot = depth + 25.0 * np.sin(x / 420.0) * np.cos(y / 560.0) + 0.03 * x
    hanging = foot + throw(y, depth)
    z = np.where(x > fault_x(y, hanging), hanging, np.where(x < fault_x(y, foot), foot, np.nan))
    z = np.where((x >= fault_x(y, foot)) & (x < fault_x(y, foot) + 2.0 * BIN) & (throw(y, depth) > 0.0), foot, z)
    z = z + np.random.default_rng(int(depth)).normal(0.0, NOISE, z.shape)
    return sh.horizon(z, spacing=(BIN, BIN), direction="down", vertical_unit="m", horizontal_unit="m", name=name)


def make_sticks():
    depths = np.linspace(850.0, 1600.0, 9)
    lines = [np.column_stack((fault_x(y, depths), np.full(9, y), -depths)) for y in np.linspace(0.0, 2500.0, 11)]
    return sh.Lines(["F"] * len(lines), lines, [str(n + 1) for n in range(len(lines))], direction="down", vertical_unit="m")


def at_row(line):
    """Where a line crosses the row of the section."""
    order = np.argsort(line[:, 1])
    return [np.interp(ROW * BIN, line[order, 1], line[order, axis]) for axis in (0, 2)]


def draw_section(axes, horizons, found):
    for name, horizon in horizons.items():
        own = horizon.columns[:, 1] == ROW
        axes.plot(horizon.x[own], horizon.z[own], ".", color=GREY, markersize=2.5)
        foot, hanging = (at_row(line) for line in found.lines[name])
        axes.plot(foot[0], -foot[1], "o", color=FOOT)
        axes.plot(hanging[0], -hanging[1], "o", color=HANGING)
        axes.annotate("", (hanging[0], -hanging[1] + 12.0), (foot[0], -hanging[1] + 12.0), arrowprops={"arrowstyle": "<->", "color": GREY})
    depths = np.linspace(900.0, 1500.0, 50)
    axes.plot(fault_x(ROW * BIN, depths), depths, color="black", linewidth=1.0)
    axes.set(title="Section: picks, cutoffs, heave", xlim=(900.0, 1950.0), ylim=(1500.0, 950.0), xlabel="x (m)", ylabel="depth (m)")


def draw_map(axes, horizons, found):
    name = NAMES[0]
    horizon = horizons[name]
    axes.scatter(horizon.x, horizon.y, c=horizon.z, s=2.0, cmap="viridis_r", marker="s", linewidths=0.0)
    for polygon in found.polygons[name]:
        axes.fill(polygon[:, 0], polygon[:, 1], facecolor="white", edgecolor="black", linewidth=1.0)
    axes.axhline(ROW * BIN, color=GREY, linewidth=0.8)
    axes.set(title="Map of the top: fault polygon", aspect="equal", xlim=(0.0, SIZE * BIN), ylim=(0.0, SIZE * BIN), xlabel="x (m)", ylabel="y (m)")


def draw_throws(axes, found):
    for name, color in zip(NAMES, COLORS[1:]):
        profile = found.profiles[name][0]
        axes.plot(profile.along, profile.throw, color=color, label=name)
        axes.fill_between(profile.along, profile.throw - 3.0 * profile.spread, profile.throw + 3.0 * profile.spread, color=color, alpha=0.25)
    axes.legend(frameon=False)
    axes.set(title="Throw along strike, and three spreads", xlabel="along strike (m)", ylabel="throw (m)", ylim=(0.0, None))


def draw_diagram(axes, found):
    diagram = found.diagrams["F"]
    pairs = [" against ".join(pair) for pair in zip(diagram.footwall, diagram.hanging_wall)]
    for color, pair in zip(COLORS, sorted(set(pairs))):
        own = [corners * (1.0, -1.0) for corners, of in zip(diagram.corners, pairs) if of == pair]
        axes.add_collection(PolyCollection(own, facecolor=color, edgecolor=color, linewidth=0.3, label=pair))
    for name in NAMES:
        for line, profile, color in zip(found.lines[name], found.profiles[name], (FOOT, HANGING)):
            axes.plot(profile.along, -line[:, 2], color=color, linewidth=1.2)
    axes.autoscale()
    axes.invert_yaxis()
    axes.legend(frameon=False, fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2)
    axes.set(title="Allan diagram: footwall against hanging wall", xlabel="along strike (m)", ylabel="depth (m)")


def main():
    horizons = {name: make_horizon(name, depth) for name, depth in zip(NAMES, DEPTHS)}
    found = sh.cutoffs(horizons, make_sticks(), largest_error=0.0)
    figure, axes = plt.subplots(2, 2, figsize=(11.0, 9.4), dpi=90)
    draw_section(axes[0, 0], horizons, found)
    draw_map(axes[0, 1], horizons, found)
    draw_throws(axes[1, 0], found)
    draw_diagram(axes[1, 1], found)
    figure.tight_layout()
    figure.savefig(pathlib.Path(sys.argv[1]) / "Cutoffs.png")


if __name__ == "__main__":
    main()
