// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPickHorizonSource
 * @brief   base of what makes horizons of scattered points: their lattice
 *
 * Points come with line numbers (inline and crossline), with places (x and y), or with both, in any order. The lattice
 * is found from them, or given. Crosslines count along its i, and inlines along its j.
 *
 * - With line numbers and places an affine map from the ones to the others is fitted by least squares. Lines that are
 *   picked at every second or fourth only make a lattice of such steps. Where all points are on one inline, or on one
 *   crossline, the step across is taken to be as long as that along it, and perpendicular.
 * - With places alone the lattice is found from them: surveys may be turned and sheared, have holes and ragged edges.
 *   The step along i is that nearer to the direction of x.
 * - With line numbers alone x is the crossline and y the inline.
 *
 * Points are moved to their columns; LatticeDeviation tells how far at most.
 */

#ifndef vtkPickHorizonSource_h
#define vtkPickHorizonSource_h

#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkSurveyHorizonSource.h"

#include <memory> // for std::unique_ptr

namespace SeismicHorizons
{
struct PickTable;
struct PlacementOptions;
}

class VTKSEISMICHORIZONS_EXPORT vtkPickHorizonSource : public vtkSurveyHorizonSource
{
public:
  vtkTypeMacro(vtkPickHorizonSource, vtkSurveyHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Where the lattice comes from.
  enum LatticeSourceKind
  {
    FromPoints = 0,
    CornerPoints = 1,
    OriginAndSteps = 2
  };

  ///@{
  /**
   * Where the lattice comes from. FromPoints: it is found. CornerPoints: from three points of the survey, for points
   * with line numbers. OriginAndSteps: from Origin, ColumnStep and RowStep. Places of the points have to agree with the
   * latter two. Default: FromPoints.
   */
  vtkSetClampMacro(LatticeSource, int, FromPoints, OriginAndSteps);
  vtkGetMacro(LatticeSource, int);
  void SetLatticeSourceToFromPoints() { this->SetLatticeSource(FromPoints); }
  void SetLatticeSourceToCornerPoints() { this->SetLatticeSource(CornerPoints); }
  void SetLatticeSourceToOriginAndSteps() { this->SetLatticeSource(OriginAndSteps); }
  ///@}

  ///@{
  /**
   * Inline, crossline, x and y of three points of the survey that are not on one line. Used with CornerPoints. Default:
   * 0 0 0 0; 0 1 1 0; 1 0 0 1.
   */
  vtkSetVector4Macro(FirstCorner, double);
  vtkGetVector4Macro(FirstCorner, double);
  vtkSetVector4Macro(SecondCorner, double);
  vtkGetVector4Macro(SecondCorner, double);
  vtkSetVector4Macro(ThirdCorner, double);
  vtkGetVector4Macro(ThirdCorner, double);
  ///@}

  ///@{
  /**
   * World x and y of a column: for points with line numbers that of the first inline and crossline there is, for others
   * any. Used with OriginAndSteps. Finite. Default: 0, 0.
   */
  vtkSetVector2Macro(Origin, double);
  vtkGetVector2Macro(Origin, double);
  ///@}

  ///@{
  /**
   * The steps in world x and y from a column to the next along i, and along j: for points with line numbers from a
   * crossline there is to the next, and from an inline to the next. Used with OriginAndSteps. Finite, and not parallel.
   * Default: 1, 0 and 0, 1.
   */
  vtkSetVector2Macro(ColumnStep, double);
  vtkGetVector2Macro(ColumnStep, double);
  vtkSetVector2Macro(RowStep, double);
  vtkGetVector2Macro(RowStep, double);
  ///@}

  ///@{
  /**
   * How far points may be off their columns, as a part of the step, along each of the two steps. A point that is
   * farther away is an error, which says how many there are. More than 0, less than 0.5. Default: 0.1.
   */
  vtkSetMacro(LatticeTolerance, double);
  vtkGetMacro(LatticeTolerance, double);
  ///@}

  /// Which point is kept when a horizon has several in one column.
  enum DuplicateChoice
  {
    StrongestAmplitude = 0,
    Topmost = 1,
    Lowest = 2,
    Sheets = 3
  };

  ///@{
  /**
   * Which point is kept when a horizon has several in one column. StrongestAmplitude: the one of largest absolute value
   * of the attribute Amplitude; of equal ones, and where there is no such attribute, the topmost. The others are left
   * out and counted in DroppedDuplicates. Sheets: all, as at reverse faults: each sheet is a horizon of its own, the
   * second named "Top (2)", told apart by connection in space (ColumnSheets.h). Default: StrongestAmplitude.
   */
  vtkSetClampMacro(DuplicatePolicy, int, StrongestAmplitude, Sheets);
  vtkGetMacro(DuplicatePolicy, int);
  void SetDuplicatePolicyToStrongestAmplitude() { this->SetDuplicatePolicy(StrongestAmplitude); }
  void SetDuplicatePolicyToTopmost() { this->SetDuplicatePolicy(Topmost); }
  void SetDuplicatePolicyToLowest() { this->SetDuplicatePolicy(Lowest); }
  void SetDuplicatePolicyToSheets() { this->SetDuplicatePolicy(Sheets); }
  ///@}

protected:
  vtkPickHorizonSource();
  ~vtkPickHorizonSource() override;

  void CheckParameters() override;
  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) override;
  std::vector<std::int64_t> CountHorizonPoints() override;
  SeismicHorizons::SurveyHorizons ReadSurvey(const SeismicHorizons::Monitor& monitor) override;

  /// The names of all horizons, before they are sheets.
  virtual std::vector<std::string> ListNames(const SeismicHorizons::Monitor& monitor) = 0;

  /// How many points each of them has, when they have been listed; empty where it is not known.
  virtual std::vector<std::int64_t> CountPicks() = 0;

  /// When the points were last found to be others, when they have been listed.
  virtual vtkMTimeType GetPickTime() = 0;

  /// The points of all horizons.
  virtual SeismicHorizons::PickTable ReadPicks(const SeismicHorizons::Monitor& monitor) = 0;

private:
  vtkPickHorizonSource(const vtkPickHorizonSource&) = delete;
  void operator=(const vtkPickHorizonSource&) = delete;

  SeismicHorizons::PlacementOptions MakeOptions();
  SeismicHorizons::SurveyHorizons PlaceAll(const SeismicHorizons::Monitor& monitor);

  int LatticeSource = FromPoints;
  double FirstCorner[4] = { 0.0, 0.0, 0.0, 0.0 };
  double SecondCorner[4] = { 0.0, 1.0, 1.0, 0.0 };
  double ThirdCorner[4] = { 1.0, 0.0, 0.0, 1.0 };
  double Origin[2] = { 0.0, 0.0 };
  double ColumnStep[2] = { 1.0, 0.0 };
  double RowStep[2] = { 0.0, 1.0 };
  double LatticeTolerance = 0.1;
  int DuplicatePolicy = StrongestAmplitude;

  struct SheetList;
  std::unique_ptr<SheetList> ListedSheets; // with DuplicatePolicy Sheets
};

#endif
