# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The page Tables.md: what was measured beside what the thesis reports."""

from vtkmodules.vtkCommonCore import vtkSMPTools

from . import meshlab, partners, reported, stages, surfaces, tables, words

PAGE = """\
# Beside the thesis

Made by `Utilities/Studies/reproduce_thesis.sh`, which measures everything on this page anew and writes the words that
have figures in them, too. The surfaces of the thesis are not public; ours are synthetic (`generate_horizons`), each
with about as many points as one of the thesis, in a box of the same proportions that is as full, and as rough in places
([the surfaces](#the-surfaces)). What the figures of the thesis show is in [Figures.md](Figures.md). All errors are
measured with [vtkHorizonSurfaceDistance](HorizonSurfaceDistance.md), both ways, between the mesh of all points and the
mesh of those that are left, in lattice units, and are divided by the diagonal of the bounding box, as the thesis has
them. Times are those of the filters, attributes included, the fastest of up to {runs} runs, on {threads} threads; those
of the thesis are from a PC of its time.{meshlab}

## In short

Beside the thesis: {thesis_words}
{cluster_words}
Beside others that make as many vertices as our rough simplification with cells of 6
([what a vertex buys](#what-a-vertex-buys); medians over the surfaces):

{rough_words}
Beside others that make as many vertices as our elaborate simplification with cells of 8:

{elaborate_words}
{own_words}
## The surfaces

{surfaces}
Points, boxes and how full these are agree. How the gaps lie and how rough the surfaces are, the thesis does not say;
but the more points the rough simplification leaves, the longer is the outline, and the fewer points are in a cell. So
ours have, beside bays, a few holes and {dropouts} of single dropouts, patches of noise: blocks of 16 columns in which
heights are off by up to {noise_height} voxels, and {noise_gaps} of the voxels are missing. Their part of the area is
the one thing fitted to a result of the thesis: with it the median of what the rough simplification leaves with s = 3,
6 and 8, each divided by what it leaves in the thesis, is 1. What all else leaves is not fitted.
{outline_words}

{contradiction}
Heights are whole, as those of voxels are, so that a mesh that passes between them has a mean error of up to a quarter
of a step even where it is right.

## Exterior boundary (figures 3.18 and 3.19)

![Time of the exterior boundary over its radius](Pictures/BoundaryTime.png)

*All outlines of a surface over the radius k, by both rules of growth. The thesis gives one number: 18 ms.*

![Outline points dropped over the threshold](Pictures/BoundaryRate.png)

*What the boundary simplification drops. The thesis's three points are from three outlines; how much is dropped
depends on how straight an outline is, and how rough along its height.*

## Rough simplification and merging (table 4.1)

*Left* is what remains of the inside and the outline together, as points and, in brackets, as a part of the input in
percent. *Merged* is MeshLab's `Merge Close Vertices`, with which the thesis compares; its figures stand under "here"
as well.

{table_4_1}
## Rough simplification (table 4.2)

{table_4_2}
## Elaborate simplification, s = 8, alone and after rough with s = 3 (table 4.3)

{table_4_3}
## Both, s = 10 after rough with s = 3, and merging (table 4.4)

{table_4_4}
## Both, s = 10 after rough with s = 6 (table 4.5)

{table_4_5}
## Both, s = 10 after rough with s = 8 (table 4.6)

{table_4_6}
## What is different from the thesis

Medians over the surfaces, and for the last three rows over the flatnesses:

{thesis_table}
- *Rough.* With s = 6 and 8 the surfaces are alike by the way they were made. With s = 3 four of ours
  leave fewer points than the thesis's, as they have to ([above](#the-surfaces)), and the largest one leaves more: in
  the thesis its cells are nearly full, and its outline must be what makes s = 6 and 8 leave as much as they do.
- *Elaborate, alone.* The thesis gives no values for its three boundary thresholds, and leaves open what the size of a
  neighbour is that was cut into pieces ([how we read it](HorizonElaborateSimplification.md#method)). Patches of noise
  make what is left depend on the flatness, as it does in the thesis. Ours is white noise, as bad as it gets: with a
  flatness of 0.03 nearly every cell in it is cut down to columns, and cells around it with them, so that we leave more
  there; with 0.12 and 0.20 about as many as the thesis, in the median.
- *Elaborate, after rough.* A cell of 8 then has at most 9 points, a piece of 4 about two, so that less is left than
  alone. The thesis gives one number for both, and says that the result does not depend on the rough step; its number is
  mostly nearer to ours alone. With s = 10 after rough with s = 3 it has nearly as many points as with s = 8; we have
  fewer.
- *Errors.* Our largest are at single voxels of noise and along the outline, whatever the cells and the flatness: with
  small cells they are larger than in the thesis, with large ones smaller. In the thesis they grow with both, so that
  its surfaces presumably have features about as wide as a cell, which our folds are too wide for. Mean errors
  are like those of the thesis, with the noise in them, which no mesh of fewer points can follow. What MeshLab's merging
  does here and there ([in short](#in-short)) tells how comparable the surfaces are.

## Triangulation (table 5.1 and figure 5.18)

All points of a surface meshed, our times with the exterior boundary. Triangles differ from those of the thesis by
what the outlines hold. The surfaces of {boxless} points, for which the thesis gives no box, have the box
and the noise of the next one in table 4.1. A program is left out of a surface when it would take longer than
{mesh_seconds:g} s on it.

{table_5_1}
![Time to mesh all points](Pictures/TriangulationTime.png)

*Where the lattice is full our triangulation searches nothing, which is why it is linear and why its two searches
differ so little on such surfaces. CGAL, where it was found, meshes the hull of as many points of horizons with
another outline; ball pivoting, with the radius it guesses, and vtkDelaunay2D mesh the points of the table.*

{meshing_words}
{left_out_meshing}
## What a vertex buys

Everybody gets to make a mesh with as many vertices as ours (within {near:.0f} % where the program lets one), and is
measured by the same meter. Errors of good meshes fall in proportion to the vertices, so that *error times vertices*
compares what each vertex was good for. Times are ratios to ours from the points to the mesh: boundary, its
simplification, simplification and triangulation, attributes included. Theirs are without attributes, and without the
mesh of all points that all but `vtkDelaunay2D` need before. The two clustering filters run with what served them best:
`vtkBinnedDecimation` with means, in cells as high as the surface; `vtkQuadricClustering` with feature edges, in cubic
cells. The others run with their defaults. MeshLab's seconds are of the processor, without reading and writing files.
Our decimation has outlines with the fewest points within half a column. `vtkGreedyTerrainDecimation` knows no blanked
pixels: gaps are filled smoothly for it, and what it makes of them is cut off along the outline; it also spends vertices
there. `vtkDelaunay2D` meshes the points that we leave, without an
outline. The outline is how far that of the mesh is off on the map, anywhere. Medians over the surfaces:

As many vertices as `rough, s = 6`:

{rough_partners}
{rough_best}
As many vertices as `elaborate, s = 8, flatness 0.03`:

{elaborate_partners}
{elaborate_best}
![Errors over vertices](Pictures/VertexWorth.png)

*The surface of {curve_surface} points. Ours, drawn heavier, keep the outline where it is on the map, by design; how far
the others move it is in the third panel.*

{left_out_partners}
### Surface by surface

As many vertices as `rough, s = 6`:

{rough_equal}
As many vertices as `elaborate, s = 8, flatness 0.03`:

{elaborate_equal}"""


def page(found, curves, meshings, paces):
    rough, elaborate = found[0].equal
    return PAGE.format(
        runs=stages.MOST_RUNS, threads=vtkSMPTools.GetEstimatedNumberOfThreads(),
        meshlab="" if meshlab.is_installed() else " MeshLab was not run.",
        thesis_words=words.thesis_sentence(found), thesis_table=words.thesis_table(found),
        rough_words=words.partner_sentences(found, rough), elaborate_words=words.partner_sentences(found, elaborate),
        surfaces=tables.surfaces(found),
        dropouts="%g %%" % (100.0 * surfaces.DROPOUTS), noise_height=surfaces.NOISE_HEIGHT,
        noise_gaps="%g %%" % (100.0 * surfaces.NOISE_GAPS), contradiction=words.contradiction_sentence(),
        outline_words=words.outline_sentence(found),
        table_4_1=tables.table_4_1(found),
        table_4_2=tables.table_4_2(found), table_4_3=tables.table_4_3(found), table_4_4=tables.table_4_4(found),
        table_4_5=tables.table_4_5_and_6(found, 6), table_4_6=tables.table_4_5_and_6(found, 8),
        cluster_words=words.cluster_sentence(found),
        boxless=words.listing(["%d" % n for n in surfaces.BOX_OF if n in reported.TRIANGULATION]),
        mesh_seconds=paces[1].most_seconds, table_5_1=tables.table_5_1(meshings),
        meshing_words=words.meshing_sentences(meshings), left_out_meshing=words.left_out(paces[1]),
        rough_best=words.best_sentence(found, rough), elaborate_best=words.best_sentence(found, elaborate),
        own_words=words.own_sentence(found),
        near=100.0 * partners.NEAR_ENOUGH, rough_partners=words.partner_table(found, rough),
        elaborate_partners=words.partner_table(found, elaborate), curve_surface="{:,}".format(curves[0]),
        left_out_partners=words.left_out(paces[0]), rough_equal=tables.equal_vertices(found, rough),
        elaborate_equal=tables.equal_vertices(found, elaborate))
