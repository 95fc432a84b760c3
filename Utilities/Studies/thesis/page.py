# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page Tables.md: our measurements beside the results of the thesis."""

from vtkmodules.vtkCommonCore import vtkSMPTools

from text import wrapped

from . import figure_section, meshlab, partners, stages, surfaces, tables, words

PAGE = """\
# Compared with the thesis

Our simplifications are compared with those of the thesis, and with other programs at the same number of vertices.
`Utilities/Studies/reproduce_thesis.sh` measures and writes this page. With `--tables FILE`, it also writes the results
for each surface (tables 4.1 to 4.6 and 5.1) and the numbers in figure captions.

- {thesis_words}
- {cluster_words}
- With as many vertices as our rough simplification (s = 6; [What a vertex buys](#what-a-vertex-buys)): {rough_best}
- With as many vertices as our elaborate simplification (s = 8): {elaborate_best}

## Method

- The surfaces of the thesis are not public. Ours are synthetic (`generate_horizons`) and have their sizes and
  proportions, with bays, holes, {dropouts} of single dropouts, and patches of noise: blocks of 16 columns with heights
  off by up to {noise_height} voxels and {noise_gaps} of the voxels missing. The area with noise is chosen so that the
  rough simplification with s = 3, 6 and 8 leaves, in the median, as many points as in the thesis.
- Errors are [distances](HorizonSurfaceDistance.md) between the mesh of all points and the mesh of the points left, in
  both directions, in lattice units, as fractions of the diagonal of the bounding box. Heights are whole numbers, so
  even a mesh between them has a mean error of up to a quarter of a vertical index.
- Times are the fastest of up to {runs} runs on {threads} threads, attributes included. Those of the thesis were
  measured on a PC of its time.{meshlab}

## What is different from the thesis

Medians of here / thesis over the surfaces, and in the last three rows also over the flatnesses:

{thesis_table}
- *Rough.* {contradiction}
- *Elaborate.* The thesis gives no values for its boundary thresholds ([our
  interpretation](HorizonCellSimplification.md#method)), and only one number for both *alone* and *after rough*.
- *Errors.* Our largest errors are at single noisy voxels and along the outline; in the thesis, they grow with cell size
  and flatness.

## What a vertex buys

Each program makes a mesh with as many vertices as ours, within {near:.0f} % where possible. Figures are medians over
the surfaces.

- Errors are multiplied by the number of vertices, since the error of a good mesh is inversely proportional to it.
  *Outline* is the largest deviation of the outline in map view.
- *Time* is from the points to the mesh. Ours includes the boundary and attributes. Theirs excludes both, and the mesh
  of all points that all but `vtkDelaunay2D` need.
- The two clustering filters run with their best settings, all others with their defaults. Holes are filled for
  `vtkGreedyTerrainDecimation`. `vtkDelaunay2D` meshes the points that our simplification leaves.

As many vertices as `rough, s = 6`:

{rough_partners}
As many vertices as `elaborate, s = 8, flatness 0.03`:

{elaborate_partners}
![Errors over vertices](Pictures/VertexWorth.png)

*The surface of {curve_surface} points. Our methods, drawn with heavier lines, preserve the outline in map view by
design.*

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
