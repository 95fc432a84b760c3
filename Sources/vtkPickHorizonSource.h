// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPickHorizonSource
 * @brief   base of sources of horizons from scattered points: their lattice
 *
 * Points have line numbers (inline and crossline), coordinates (x and y), or both, in any order. The lattice is found
 * from them, or given. Crosslines count along i, inlines along j.
 *
 * How the lattice is found:
 * - Line numbers and coordinates: an affine map between them, by least squares. Steps are those of the picked lines,
 *   such as every fourth. If all points are on one inline or crossline, the step across is perpendicular and equally
 *   long
 * - Coordinates alone: surveys may be rotated and sheared, have holes and ragged edges. The step along i is the one
 *   nearer to x
 * - Line numbers alone: x is the crossline and y the inline
 *
 * Points are moved to their columns; LatticeDeviation is the largest distance.
 */

#ifndef vtkPickHorizonSource_h
#define vtkPickHorizonSource_h

#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h"
#include "vtkSurveyHorizonSource.h"

#include <memory>

namespace SeismicHorizons
{
struct PickTable;
struct PlacementOptions;
struct SurveyDescription;
}

class VTKSEISMICHORIZONS_EXPORT vtkPickHorizonSource : public vtkSurveyHorizonSource
{
public:
  vtkTypeMacro(vtkPickHorizonSource, vtkSurveyHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Source of the lattice. FromPoints: the picks. CornerPoints: three points. OriginAndSteps: a column and steps from
   * it. NoLattice: none, only for guides and limits of an extraction. See "Lattice" in HorizonText.md. Default:
   * FromPoints.
   *
   * Points must agree with a lattice that is given.
   */
  vtkHorizonChoice4Macro(LatticeSource, LatticeSourceKind, FromPoints, CornerPoints, OriginAndSteps, NoLattice);

  /**
   * With CornerPoints: inline, crossline, x and y of one of three points, not collinear. Unit: line numbers, world
   * units. Range: finite. Default: 0, 0, 0, 0.
   */
  vtkHorizonVectorMacro(FirstCorner, double, 4);

  /**
   * With CornerPoints: the second. Unit: line numbers, world units. Range: finite. Default: 0, 1, 1, 0.
   */
  vtkHorizonVectorMacro(SecondCorner, double, 4);

  /**
   * With CornerPoints: the third. Unit: line numbers, world units. Range: finite. Default: 1, 0, 0, 1.
   */
  vtkHorizonVectorMacro(ThirdCorner, double, 4);

  /**
   * With OriginAndSteps: x and y of a column, or of the first inline and crossline. Unit: world units. Range: finite.
   * Default: 0, 0.
   */
  vtkHorizonVectorMacro(Origin, double, 2);

  /**
   * With OriginAndSteps: x and y from a column or crossline to the next. Unit: world units. Range: finite, not parallel
   * to RowStep. Default: 1, 0.
   */
  vtkHorizonVectorMacro(ColumnStep, double, 2);

  /**
   * With OriginAndSteps: x and y from a row or inline to the next. Unit: world units. Range: finite, not parallel to
   * ColumnStep. Default: 0, 1.
   */
  vtkHorizonVectorMacro(RowStep, double, 2);

  /**
   * Largest distance of points from columns; farther ones are stray. Unit: columns. Range: more than 0, less than 0.5.
   * Default: 0.1.
   */
  vtkHorizonNumberMacro(LatticeTolerance, double);

  /**
   * Picks off the lattice or far from others. Stop: an error; on the lattice, a warning. LeaveOut: drops up to a tenth,
   * with a warning. Default: Stop.
   *
   * With Gridding, picks far from all others are an error, or a warning if the lattice is given.
   */
  vtkHorizonChoice2Macro(StrayPicks, StrayChoice, Stop, LeaveOut);

  /**
   * Which of several points in a column, with Gridding at a position, is kept. StrongestAmplitude: the largest absolute
   * Amplitude, then the topmost. Sheets: all, for reverse faults. Mean: their mean, for overlapping surveys. See
   * "Duplicates" in HorizonText.md. Default: StrongestAmplitude.
   *
   * The second sheet is named "Top (2)"; see ColumnSheets.h.
   */
  vtkHorizonChoice5Macro(DuplicatePolicy, DuplicateChoice, StrongestAmplitude, Topmost, Lowest, Sheets, Mean);

  /**
   * Grids picks off a lattice, such as 2D lines or wells. Plate: smooth, close to all picks. Nearest: z of the nearest
   * pick. See "Gridding" in HorizonText.md. Default: NoGridding.
   *
   * The lattice is that of LatticeSource OriginAndSteps, or one along x and y with about a column for each pick.
   */
  vtkHorizonChoice3Macro(Gridding, GriddingChoice, NoGridding, Plate, Nearest);

  /**
   * With Gridding: how far from picks to fill. 0: their convex hull. Unit: world units; lines for line numbers alone.
   * Range: 0 to 1e12. Default: 0.
   */
  vtkHorizonNumberMacro(GriddingRadius, double);

  /**
   * With Plate: larger values remove more noise and misties. Range: 0 to 1e6. Default: 0.01.
   */
  vtkHorizonNumberMacro(GriddingSmoothing, double);

protected:
  vtkPickHorizonSource();
  ~vtkPickHorizonSource() override;

  void CheckParameters() override;
  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) override;
  std::vector<std::int64_t> CountHorizonPoints() override;
  SeismicHorizons::SurveyHorizons ReadSurvey(const SeismicHorizons::Monitor& monitor) override;

  /// Horizons may still have several sheets.
  virtual std::vector<std::string> ListNames(const SeismicHorizons::Monitor& monitor) = 0;

  /// Returns the points of each listed horizon, or nothing.
  virtual std::vector<std::int64_t> CountPicks() = 0;

  /// Modification time of the points, as of the last listing.
  virtual vtkMTimeType GetPickTime() = 0;

  virtual SeismicHorizons::PickTable ReadPicks(const SeismicHorizons::Monitor& monitor) = 0;

private:
  vtkPickHorizonSource(const vtkPickHorizonSource&) = delete;
  void operator=(const vtkPickHorizonSource&) = delete;

  SeismicHorizons::PlacementOptions MakeOptions(const SeismicHorizons::SurveyDescription& survey);
  SeismicHorizons::SurveyHorizons Place(SeismicHorizons::PickTable picks, const SeismicHorizons::Monitor& monitor);
  SeismicHorizons::SurveyHorizons PlaceAll(const SeismicHorizons::Monitor& monitor);

  int LatticeSource = FromPoints;
  double FirstCorner[4] = { 0.0, 0.0, 0.0, 0.0 };
  double SecondCorner[4] = { 0.0, 1.0, 1.0, 0.0 };
  double ThirdCorner[4] = { 1.0, 0.0, 0.0, 1.0 };
  double Origin[2] = { 0.0, 0.0 };
  double ColumnStep[2] = { 1.0, 0.0 };
  double RowStep[2] = { 0.0, 1.0 };
  double LatticeTolerance = 0.1;
  int StrayPicks = Stop;
  int DuplicatePolicy = StrongestAmplitude;
  int Gridding = NoGridding;
  double GriddingRadius = 0.0;
  double GriddingSmoothing = 0.01;

  struct SheetList;
  std::unique_ptr<SheetList> ListedSheets; // For DuplicatePolicy Sheets.
};

#endif
