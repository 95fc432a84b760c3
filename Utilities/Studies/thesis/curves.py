# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The curves, as pictures."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  the back-end is selected first
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter  # noqa: E402

from . import reported  # noqa: E402

RESOLUTION = 110
COLORS = ("#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#8c564b", "#17becf", "#7f7f7f", "#bcbd22", "#e377c2")
THESIS = "black"
STYLE = {"font.size": 9, "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "axes.axisbelow": True,
         "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "lines.markersize": 4,
         "lines.linewidth": 1.6}


def plain(value, _):
    return "{:,.0f}".format(value) if value >= 1.0 else "%g" % value


def panels(number, size, same_heights=False):
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(1, number, figsize=size, layout="constrained", squeeze=False, sharey=same_heights)
    return figure, list(axes[0])


def logarithmic(axis):
    axis.set_major_formatter(FuncFormatter(plain))
    axis.set_minor_formatter(NullFormatter())


def legend(axis):
    """Places the legend to the right of the panel."""
    axis.legend(loc="center left", bbox_to_anchor=(1.02, 0.5))


def crowded(axis):
    """Adds ticks between the powers of ten, for short ranges."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    logarithmic(axis)


def save(figure, path):
    figure.savefig(path, dpi=RESOLUTION)
    plt.close(figure)


def boundary_time(found, path):
    """Draws figure 3.18."""
    figure, axes = panels(2, (9.0, 3.9), same_heights=True)
    for axis, rule in zip(axes, found[0].boundary_seconds):
        for color, s in zip(COLORS, found):
            points = s.boundary_seconds[rule]
            axis.plot([k for k, _ in points], [1000.0 * t for _, t in points], "o-", color=color,
                      label="{:,} points".format(s.size))
        size, radius, spent = reported.BOUNDARY_TIME
        axis.plot(radius, spent, "*", color=THESIS, markersize=11, label="thesis, {:,} points".format(size))
        axis.set_yscale("log")
        crowded(axis.yaxis)
        axis.set_title(rule)
        axis.set_xlabel("radius k (columns)")
    axes[0].set_ylabel("exterior boundary (ms)")
    legend(axes[-1])
    save(figure, path)


def boundary_rate(found, path):
    """Draws figure 3.19."""
    figure, (axis,) = panels(1, (6.8, 3.9))
    for color, s in zip(COLORS, found):
        axis.plot(*zip(*s.boundary_rates), "o-", color=color, label="{:,} points".format(s.size))
    axis.plot(*zip(*reported.BOUNDARY_RATES), "*", color=THESIS, markersize=11, label="thesis, three outlines")
    axis.set_xlabel("distance threshold t (lattice units)")
    axis.set_ylabel("outline points dropped (%)")
    axis.set_ylim(0, 100)
    legend(axis)
    save(figure, path)


def triangulation_time(meshings, others, path):
    """Draws figure 5.18. `others` are further programs, as lists of (points, seconds) by name."""
    figure, (axis,) = panels(1, (7.6, 4.6))
    names = {"VTS": "voxel traversal", "CTC": "compactness", "BP": "ball pivoting (MeshLab)"}
    curves = {"%s, here" % title: [(m.points, m.seconds[name]) for m in meshings if name in m.seconds]
              for name, title in {**names, "vtkDelaunay2D": "vtkDelaunay2D"}.items()}
    curves.update(("%s, here" % name, points) for name, points in others.items())
    styles = {"voxel traversal, here": ("o-", COLORS[0]), "compactness, here": ("s--", COLORS[6])}
    free = iter(zip(COLORS[1:6:1], "^vD<>"))
    for name, points in curves.items():
        if points:
            style, color = styles.get(name) or (lambda c, m: (m + "-", c))(*next(free))
            axis.plot(*zip(*sorted(points)), style, color=color, label=name)
    for (name, title), dash in zip(names.items(), ("o:", "s:", "^:")):
        points = [(n, row[name][1] / 1000.0) for n, row in sorted(reported.TRIANGULATION.items())]
        axis.plot(*zip(*points), dash, color=THESIS, alpha=0.65, markerfacecolor="white", linewidth=1.1,
                  label="%s, thesis" % title)
    axis.set_xscale("log")
    axis.set_yscale("log")
    logarithmic(axis.xaxis)
    logarithmic(axis.yaxis)
    axis.set_xticks((20000, 50000, 100000, 200000, 500000))
    axis.set_xlabel("points")
    axis.set_ylabel("seconds to mesh all points")
    legend(axis)
    save(figure, path)


def vertex_worth(curves, title, path):
    """Draws errors against vertices for all programs; our curve is thicker."""
    figure, axes = panels(3, (12.0, 4.2))
    ours = [name for name in curves if not name.startswith(("vtk", "MeshLab"))]
    for number, (name, worths) in enumerate(curves.items()):
        mine = name in ours
        for axis, what in zip(axes, ("largest", "mean", "outline")):
            values = sorted((w.vertices, getattr(w, what)) for w in worths)
            axis.plot(*zip(*values), "o-" if mine else "^--", color=COLORS[number % len(COLORS)],
                      linewidth=2.4 if mine else 1.2, label="ours, %s" % name.replace("our ", "") if mine else name)
    for axis, label in zip(axes, ("largest error / diagonal", "mean error / diagonal", "outline off (columns)")):
        axis.set_xscale("log")
        logarithmic(axis.xaxis)
        axis.set_xlabel("vertices")
        axis.set_title(label)
    for axis in axes[:2]:
        axis.set_yscale("log")
        crowded(axis.yaxis)
    axes[2].set_yscale("symlog", linthresh=1.0)
    axes[2].set_yticks((0.0, 1.0, 10.0, 100.0))
    axes[2].set_ylim(bottom=-0.2)
    logarithmic(axes[2].yaxis)
    legend(axes[-1])
    figure.suptitle(title)
    save(figure, path)
