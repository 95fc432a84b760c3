// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSurfaceDistance
 * @brief   measures the distances between a mesh and the horizon it represents, in both directions
 *
 * Input 0, the reference: a triangle mesh, or a horizon without triangles, which is meshed at full resolution inside
 * its loops, or where it has none inside its exterior boundary of the given Radius, holes closed. Input 1: a triangle
 * mesh from any source. Either may be a composite dataset of horizons; they are then matched by name ("Horizon <ID>"),
 * and each must have its counterpart.
 *
 * Outputs 0 and 1: the reference as it was meshed, and the mesh, with all their arrays and these point arrays:
 *  - Distance (double): to the nearest place of the other surface, in DistanceUnit
 *  - VerticalDistance (double): z of the point less that of the other surface right above or below it, in DistanceUnit,
 *    positive where the point is the higher one in the world; nan where the other surface has nothing above or below
 * and field data (double), with three tuples (from the reference to the mesh, from the mesh to the reference, both) of
 * three components (in lattice units, in world units, divided by the diagonal of the reference's bounding box in
 * lattice units):
 *  - LargestDistance: no place is farther, up to rounding
 *  - LargestDistanceFound: the largest one of a place; at most 1 % less, unless the effort ran out before
 *  - MeanDistance, RmsDistance, DistancePercentile50, 90, 95 and 99: over the faces, weighted by area
 *  - OutlineDistance: the largest distance in plan of one outline to the other; nan where a surface has none
 * and Grading, two components: median and 95th percentile, over the corners of all triangles, of the ratio of the
 * longer to the shorter side that meet there, in lattice units.
 *
 * Output 2: the same figures as a vtkTable, with a row for each horizon, direction and unit, and the columns Horizon,
 * Direction, Unit, those named above with GradingMedian and Grading95 of the surface where the direction begins, and
 * Samples, the number of places on its faces.
 *
 * Output 3: a histogram of the distances of both directions in the DistanceUnit, as a vtkTable of 31 rows for each
 * horizon: Horizon, Unit, bin_extents, where a bin begins, and Area (%), the share of the area of both surfaces. 30 bins
 * go to the 99th percentile, the last one to the largest distance.
 *
 * The measure is that of Metro (Cignoni, Rocchini and Scopigno 1998, "Metro: measuring error on simplified surfaces";
 * thesis 4.4). Vertices of a surface, and samples that are spread evenly over its edges and faces, are measured to the
 * other surface; the distance of each of them is exact. The largest distance is bounded from above by a search that
 * cuts triangles into pieces where it may be larger than any found (Tang, Lee and Kim 2009, "Interactive Hausdorff
 * distance computation for general polygonal models"). The nearest place in lattice units need not be the nearest one
 * in world units, so that everything is measured in both. Where a lattice unit is as long in all directions of the
 * world, one follows from the other. The lattice is that of the reference, else that of the mesh; where neither has
 * one, lattice units are those of the world.
 *
 * Runs on several threads, and gives the same bytes on any number of them. Near linear; about 70 bytes per triangle
 * of both surfaces beyond input and output. Percentiles are within a thousandth of their size, means are exact for the
 * samples.
 *
 * In a program of several processes each of them measures the references it has; meshes that are elsewhere are sent to
 * it, and back. The tables are on the first one, and a horizon must have all its points on one of them.
 *
 * With InvalidHorizons set to LeaveOut, a pair that cannot be measured has empty surfaces and no rows.
 *
 * Errors: 2^30 points or triangles, no triangles or no area in a mesh (but at filled points), other cells than
 * triangles, a horizon without counterpart, points that are not finite, a reference without triangles that is no
 * horizon on a lattice.
 *
 * Triangles that close faults (1 in the cell data array Fault) are no part of either surface.
 *
 * @sa vtkHorizonTriangulation vtkDistancePolyDataFilter vtkHausdorffDistancePointSetFilter
 */

#ifndef vtkHorizonSurfaceDistance_h
#define vtkHorizonSurfaceDistance_h

#include "vtkHorizonStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
class Monitor;
struct HorizonPair;
}
class vtkTable;

class VTKSEISMICHORIZONS_EXPORT vtkHorizonSurfaceDistance : public vtkHorizonStage
{
public:
  static vtkHorizonSurfaceDistance* New();
  vtkTypeMacro(vtkHorizonSurfaceDistance, vtkHorizonStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Values of DistanceUnit.
  enum DistanceUnits
  {
    Lattice = 0,
    World = 1
  };

  ///@{
  /**
   * The unit of the arrays Distance and VerticalDistance; figures are in both. Lattice: one column sideways, one
   * vertical index up. World: the unit of the coordinates. Default: Lattice.
   */
  vtkSetClampMacro(DistanceUnit, int, Lattice, World);
  vtkGetMacro(DistanceUnit, int);
  void SetDistanceUnitToLattice() { this->SetDistanceUnit(Lattice); }
  void SetDistanceUnitToWorld() { this->SetDistanceUnit(World); }
  ///@}

  ///@{
  /**
   * How many samples on the faces of each surface, for each point of the larger surface; at least 10,000. More make
   * means and percentiles more exact. Unit: places per point. Range: 0.01 to 1000. Default: 2.
   */
  vtkSetMacro(SamplesPerPoint, double);
  vtkGetMacro(SamplesPerPoint, double);
  ///@}

  ///@{
  /**
   * The seed of the random samples on faces. Range: at least 0. Default: 1.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * For a reference with neither triangles nor outlines: the Radius of its vtkHorizonExteriorBoundary. Unit: columns.
   * Range: 1 to 32. Default: 1.
   */
  vtkSetMacro(Radius, int);
  vtkGetMacro(Radius, int);
  ///@}

  ///@{
  /**
   * Whether figures include points added by vtkHorizonHoleFilling, with the edges and triangles at them. Default: off.
   */
  vtkSetMacro(IncludeFilledPoints, bool);
  vtkGetMacro(IncludeFilledPoints, bool);
  vtkBooleanMacro(IncludeFilledPoints, bool);
  ///@}

protected:
  vtkHorizonSurfaceDistance();
  ~vtkHorizonSurfaceDistance() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonSurfaceDistance(const vtkHorizonSurfaceDistance&) = delete;
  void operator=(const vtkHorizonSurfaceDistance&) = delete;

  void MeasurePair(const SeismicHorizons::HorizonPair& pair, const SeismicHorizons::Monitor& monitor) const;

  int DistanceUnit = Lattice;
  double SamplesPerPoint = 2.0;
  int Seed = 1;
  int Radius = 1;
  bool IncludeFilledPoints = false;
};

#endif
