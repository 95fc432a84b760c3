// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonSurfaceDistance
 * @brief   measures the distances between a mesh and the horizon it represents, in both directions
 *
 * Input 0, the reference: a triangle mesh, or a horizon without triangles, which is meshed at full resolution inside
 * its loops, or else inside its exterior boundary: with the radius and the open holes of a mesh by vtkHorizonSurface,
 * else of the given Radius, with holes closed. Input 1, or a second connection of input 0: a triangle mesh from any
 * source. In composite datasets each horizon needs a counterpart of the same name. If the first has triangles and the
 * second has none, they are swapped, unless only one is a composite dataset.
 *
 * Outputs 0 and 1: the reference as it was meshed, and the mesh, with all their arrays and new point arrays:
 *  - Distance (double): to the nearest place of the other surface, in DistanceUnit;
 *  - VerticalDistance (double): z of the point less that of the other surface above or below it, in DistanceUnit; nan
 *    where that has nothing above or below.
 *
 * New field data (double) has three tuples (from the reference to the mesh, from the mesh to the reference, both) of
 * three components (lattice units, world units, and lattice units divided by the diagonal of the bounding box of the
 * reference):
 *  - LargestDistance: no place is farther, up to rounding;
 *  - LargestDistanceFound: the largest distance of a place; at most 1 % less, unless the effort ran out;
 *  - MeanDistance, RmsDistance, DistancePercentile50, 90, 95 and 99: over the faces, weighted by area;
 *  - OutlineDistance: the largest distance on the map of one outline to the other; nan without an outline.
 *
 * Grading has two components: median and 95th percentile, over the corners of all triangles, of the ratio of the longer
 * to the shorter side, in lattice units.
 *
 * Output 2: the same figures as a vtkTable, with a row for each horizon, direction and unit, GradingMedian and
 * Grading95 of the surface where the direction begins, and Samples, the number of places on its faces. Output 3: a
 * histogram of the distances of both directions in the DistanceUnit, as a vtkTable: Horizon, Unit, bin_extents, where a
 * bin begins, and Area (%). 30 bins lead to the 99th percentile, the last one to the largest distance.
 *
 * The measure is that of Metro (Cignoni, Rocchini and Scopigno 1998; thesis 4.4): distances of vertices and of samples
 * on edges and faces, each exact. The largest distance is bounded from above by splitting triangles where it may be
 * larger (Tang, Lee and Kim 2009). Lattice and world distances are measured separately, since the nearest places
 * differ. The lattice is that of the reference, or else of the mesh; without one, lattice units are world units.
 *
 * The result is the same for any number of threads. Memory beyond input and output is about 70 bytes per triangle. With
 * several processes, each measures its references, meshes are sent to it and back, and the first process has the
 * tables. With InvalidHorizons set to LeaveOut, a pair that cannot be measured has empty surfaces and no rows.
 * Triangles that close faults (1 in the cell data array Fault) are ignored.
 *
 * Errors: 2^30 points or triangles, a mesh without triangles or area, other cells than triangles, a horizon without
 * counterpart, points that are not finite, or a reference without triangles that is not a horizon on a lattice.
 *
 * @sa vtkHorizonTriangulation vtkDistancePolyDataFilter vtkHausdorffDistancePointSetFilter
 */

#ifndef vtkHorizonSurfaceDistance_h
#define vtkHorizonSurfaceDistance_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <string> // for a member

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

  ///@{
  /**
   * The meshes to measure, from any program, or what to compare them with; several are matched with the reference by
   * name. Range: meshes or points. Default: none.
   *
   * Input 1.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void RemoveMesh() { this->SetInputConnection(1, nullptr); }
  ///@}

  /**
   * Unit of the arrays Distance and VerticalDistance; figures have both. Steps: columns and vertical indices. World:
   * unit of coordinates. Default: Steps.
   */
  vtkHorizonChoice2Macro(DistanceUnit, DistanceUnits, Steps, World);

  /**
   * Samples on each surface per point of the larger one, at least 10,000. More make means and percentiles more exact.
   * Unit: places per point. Range: 0.01 to 1000. Default: 2.
   */
  vtkHorizonNumberMacro(SamplesPerPoint, double);

  /**
   * Seed of the random samples. Range: at least 0. Default: 1.
   */
  vtkHorizonNumberMacro(Seed, int);

  /**
   * Radius of the vtkHorizonExteriorBoundary for a reference without triangles or outlines, unless the mesh is from
   * vtkHorizonSurface. Unit: columns. Range: 1 to 32. Default: 1.
   */
  vtkHorizonNumberMacro(Radius, int);

  /**
   * Include points added by vtkHorizonHoleFilling in figures. Default: off.
   *
   * With the edges and triangles at them.
   */
  vtkHorizonFlagMacro(IncludeFilledPoints);

  /**
   * Distances between each pair of surfaces, in both directions, in DistanceUnit.
   *
   * Lines of text, on the first process. Empty before the first update, and after an error; after a stop they say so.
   */
  const char* GetResults() { return this->Results.c_str(); }

protected:
  vtkHorizonSurfaceDistance();
  ~vtkHorizonSurfaceDistance() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonSurfaceDistance(const vtkHorizonSurfaceDistance&) = delete;
  void operator=(const vtkHorizonSurfaceDistance&) = delete;

  void MeasurePair(const SeismicHorizons::HorizonPair& pair, const SeismicHorizons::Monitor& monitor) const;

  int DistanceUnit = Steps;
  double SamplesPerPoint = 2.0;
  int Seed = 1;
  int Radius = 1;
  bool IncludeFilledPoints = false;
  std::string Results;
};

#endif
