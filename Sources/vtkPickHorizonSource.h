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
   * Where the lattice comes from. FromPoints: line numbers, x and y, or both. CornerPoints: line numbers and
   * coordinates of three points. OriginAndSteps: a column and the steps to its neighbours. NoLattice: picks stay at x
   * and y, as guides and limits of an extraction, which no other stage takes. See "Lattice" in HorizonText.md.
   * Default: FromPoints.
   *
   * Points must agree with a lattice that is given.
   */
  vtkHorizonChoice4Macro(LatticeSource, LatticeSourceKind, FromPoints, CornerPoints, OriginAndSteps, NoLattice);

  /**
   * With CornerPoints: inline, crossline, x and y of a point; the three not on one line. Unit: line numbers, world
   * units. Range: finite. Default: 0, 0, 0, 0.
   */
  vtkHorizonVectorMacro(FirstCorner, double, 4);

  /**
   * With CornerPoints: a second point. Unit: line numbers, world units. Range: finite. Default: 0, 1, 1, 0.
   */
  vtkHorizonVectorMacro(SecondCorner, double, 4);

  /**
   * With CornerPoints: a third point. Unit: line numbers, world units. Range: finite. Default: 1, 0, 0, 1.
   */
  vtkHorizonVectorMacro(ThirdCorner, double, 4);

  /**
   * With OriginAndSteps: x and y of a column; with line numbers, of the first inline and crossline. Unit: world units.
   * Range: finite. Default: 0, 0.
   */
  vtkHorizonVectorMacro(Origin, double, 2);

  /**
   * With OriginAndSteps: the step in x and y to the next column, or crossline of the data. Unit: world units. Range:
   * finite, not parallel to RowStep. Default: 1, 0.
   */
  vtkHorizonVectorMacro(ColumnStep, double, 2);

  /**
   * With OriginAndSteps: the step in x and y to the next row, or inline of the data. Unit: world units. Range: finite,
   * not parallel to ColumnStep. Default: 0, 1.
   */
  vtkHorizonVectorMacro(RowStep, double, 2);

  /**
   * The largest distance of points from their columns, as a fraction of each step; farther ones are an error. Unit:
   * columns. Range: more than 0, less than 0.5. Default: 0.1.
   */
  vtkHorizonNumberMacro(LatticeTolerance, double);

  /**
   * How picks off the lattice, or far from all others, are treated. Stop: an error, or a warning for distant ones on
   * the lattice. LeaveOut: up to a tenth of all picks are left out, with a warning. Default: Stop.
   *
   * With Gridding, picks far from all others are an error, or a warning if the lattice is given.
   */
  vtkHorizonChoice2Macro(StrayPicks, StrayChoice, Stop, LeaveOut);

  /**
   * Which of several points in one column is kept; with Gridding, of several at one position. StrongestAmplitude: the
   * one with the largest absolute value of the attribute Amplitude, then the topmost. Topmost, Lowest: by height.
   * Sheets: all, as at reverse faults. Mean: one with the means of z and of attributes, as where surveys overlap. See
   * "Duplicates" in HorizonText.md. Default: StrongestAmplitude.
   *
   * The second sheet is named "Top (2)"; see ColumnSheets.h.
   */
  vtkHorizonChoice5Macro(DuplicatePolicy, DuplicateChoice, StrongestAmplitude, Topmost, Lowest, Sheets, Mean);

  /**
   * Makes a horizon of picks off any lattice, such as 2D lines, wells or scattered points. Plate: a thin plate near all
   * of them. Nearest: each column has the z of the nearest pick. See "Gridding" in HorizonText.md. Default:
   * NoGridding.
   *
   * The lattice is that of LatticeSource OriginAndSteps, or one along x and y with about a column for each pick.
   */
  vtkHorizonChoice3Macro(Gridding, GriddingChoice, NoGridding, Plate, Nearest);

  /**
   * With Gridding, the largest distance of filled columns from a pick, whose own column is always filled; in lines for
   * line numbers alone. 0: the convex hull of the picks. Unit: world units. Range: 0 to 1e12. Default: 0.
   */
  vtkHorizonNumberMacro(GriddingRadius, double);

  /**
   * With Gridding Plate, how far the surface may depart from picks: larger values remove noise, and misties at line
   * crossings. Range: 0 to 1e6. Default: 0.01.
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
