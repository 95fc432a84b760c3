# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page Tables.md: our measurements beside the results of the thesis."""

from vtkmodules.vtkCommonCore import vtkSMPTools

from text import wrapped

from . import figure_section, meshlab, partners, stages, surfaces, tables, words

PAGE = """\
# Beside the thesis

Our simplifications compared with the thesis, and with other programs at the same number of vertices.
`Utilities/Studies/reproduce_thesis.sh` measures and writes this page. With `--tables FILE` it also writes the surfaces,
tables 4.1 to 4.6 and 5.1 with a row for each surface, and the numbers in captions of figures.

- {thesis_words}
- {cluster_words}
- With as many vertices as our rough simplification (s = 6; [What a vertex buys](#what-a-vertex-buys)): {rough_best}
- With as many vertices as our elaborate simplification (s = 8): {elaborate_best}

## Method

- The surfaces of the thesis are not public. Ours are synthetic (`generate_horizons`) and have its sizes and
  proportions, with bays, holes, {dropouts} of single dropouts, and patches of noise: blocks of 16 columns with heights
  off by up to {noise_height} voxels and {noise_gaps} of the voxels missing. The area of noise is fitted so that the
  rough simplification with s = 3, 6 and 8 leaves in the median as many points as in the thesis.
- Errors are [distances](HorizonSurfaceDistance.md) between the mesh of all points and that of the points left, both
  ways, in lattice units, divided by the diagonal of the bounding box as in the thesis. Heights are whole numbers: a
  mesh that passes between them has a mean error of up to a quarter of a vertical index.
- Times are the fastest of up to {runs} runs on {threads} threads, attributes included. Those of the thesis are from a
  PC of its time.{meshlab}

## What is different from the thesis

Medians of here / thesis over the surfaces, in the last three rows also over the flatnesses:

{thesis_table}
- *Rough.* {contradiction}
- *Elaborate.* The thesis gives no values for its boundary thresholds ([our
  interpretation](HorizonCellSimplification.md#method)), and one number for alone and after rough.
- *Errors.* Our largest are at single voxels of noise and along the outline; in the thesis they grow with cells and
  flatness.

## What a vertex buys

Each program makes a mesh with as many vertices as ours, within {near:.0f} % where possible. Figures are medians over
the surfaces.

- Errors are multiplied by the vertices, since those of good meshes fall in proportion. *Outline* is the largest distance
  of the mesh's outline on the map.
- *Time* is from the points to the mesh. Ours includes the boundary and attributes; theirs neither, nor, except for
  `vtkDelaunay2D`, the mesh of all points that they need.
- The two clustering filters have their best settings; the others have their defaults. For `vtkGreedyTerrainDecimation`
  holes are filled. `vtkDelaunay2D` meshes the points that we leave.

As many vertices as `rough, s = 6`:

{rough_partners}
As many vertices as `elaborate, s = 8, flatness 0.03`:

{elaborate_partners}
![Errors over vertices](Pictures/VertexWorth.png)

*The surface of {curve_surface} points. Ours, drawn heavier, keep the outline in place on the map by design.*

{left_out_partners}
{figures}"""

ALL_TABLES = """\
# Surfaces, tables 4.1 to 4.6 and 5.1, and figures of the thesis

Points left in percent of the input, errors as parts of the diagonal, milliseconds.

## The surfaces

{surfaces}
{outline_words}

## Rough simplification and merging (tables 4.1, 4.2 and 4.4)

{rough_table}
## Elaborate simplification, s = 8, alone and after rough with s = 3 (table 4.3)

{elaborate_table}
## Both, s = 10 after rough with s = 3 (table 4.4)

{both_after_3}
## Both, s = 10 after rough with s = 6 (table 4.5)

{both_after_6}
## Both, s = 10 after rough with s = 8 (table 4.6)

{both_after_8}
## Triangulation (table 5.1)

All points of a surface are meshed; our times include the exterior boundary. VTS is voxel traversal. Ball pivoting has
the radius it guesses.

{table_5_1}
{left_out_meshing}
## Captions of figures

Errors are the largest and the mean.

{captions}"""


def all_tables(found, meshings, paces, shown):
    """Returns the tables behind the medians of the page, and the figures."""
    return wrapped(ALL_TABLES.format(
        surfaces=tables.surfaces(found), outline_words=words.outline_sentence(found),
        rough_table=tables.rough(found), elaborate_table=tables.elaborate(found), both_after_3=tables.both(found, 3),
        both_after_6=tables.both(found, 6), both_after_8=tables.both(found, 8), table_5_1=tables.table_5_1(meshings),
        left_out_meshing=words.left_out(paces[1]), captions=figure_section.rows(shown)))


def page(found, curves, paces, shown):
    """`shown` are the figures of surfaces."""
    rough, elaborate = found[0].equal
    return wrapped(PAGE.format(
        runs=stages.MOST_RUNS, threads=vtkSMPTools.GetEstimatedNumberOfThreads(),
        meshlab="" if meshlab.is_installed() else " MeshLab was not run.",
        thesis_words=words.thesis_sentence(found), cluster_words=words.cluster_sentence(found),
        rough_best=words.best_sentence(found, rough), elaborate_best=words.best_sentence(found, elaborate),
        dropouts="%g %%" % (100.0 * surfaces.DROPOUTS),
        noise_height=surfaces.NOISE_HEIGHT, noise_gaps="%g %%" % (100.0 * surfaces.NOISE_GAPS),
        contradiction=words.contradiction_sentence(), thesis_table=words.thesis_table(found),
        near=100.0 * partners.NEAR_ENOUGH, rough_partners=words.partner_table(found, rough),
        elaborate_partners=words.partner_table(found, elaborate), curve_surface="{:,}".format(curves[0]),
        left_out_partners=words.left_out(paces[0]), figures=figure_section.section(shown, meshlab.is_installed())))
