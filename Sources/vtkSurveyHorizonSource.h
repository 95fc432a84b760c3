// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurveyHorizonSource
 * @brief   base of sources of horizons from z alone: vertical indices, units and names
 *
 * Each horizon becomes a vtkPolyData with one point and one vertex cell per column that has a z: the input of the
 * stages. World z is z, or its negative if z increases downwards.
 *
 * Thresholds of the stages are in lattice units, so z also becomes vertical indices. Index 0 is the multiple of the
 * step at or below the smallest z. With VerticalStep 0 each horizon has its own step and index 0, else all share them.
 *
 * Point data, one component each:
 * - SurfaceId (int): the number of the horizon, from 1
 * - VerticalIndex (int): the nearest vertical index; the active scalars
 * - RealZ (double): z as in the data
 * - attributes (double) under their own names, except PointCount; nan for no value
 *
 * Field data, one tuple each:
 * - LatticeDimensions (int, 3 components), LatticeToWorld (double, 16 components), VerticalDirection (int): as from
 *   vtkVerneySparseMatrixReader
 * - LineNumbers (double, 4 components): the first inline, its step per row, the first crossline, and its step per
 *   column; only if known
 * - LatticeDeviation (double): the largest distance of a point from its column, in columns
 * - DroppedDuplicates, DroppedNulls (vtkIdType): points left out because another is in their column, or because they
 *   have no z; DroppedRepeats (vtkIdType): of the duplicates those with a z that another one there has
 * - LargestConflict (double): the largest difference of z in a column with several, of which one was kept
 * - VerticalUnit, VerticalDomain, HorizontalUnit, CoordinateSystem (string): if the data or the user state them
 *
 * @sa vtkHorizonTextReader vtkHorizonGridReader vtkHorizonFromPoints vtkHorizonFromImage
 */

#ifndef vtkSurveyHorizonSource_h
#define vtkSurveyHorizonSource_h

#include "vtkHorizonProperty.h"
#include "vtkHorizonSource.h"
#include "vtkSeismicHorizonsModule.h"

namespace SeismicHorizons
{
struct SurveyDescription;
struct SurveyHorizons;
}

class VTKSEISMICHORIZONS_EXPORT vtkSurveyHorizonSource : public vtkHorizonSource
{
public:
  vtkTypeMacro(vtkSurveyHorizonSource, vtkHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Length of a vertical index, the unit of thresholds. 0: chosen for each horizon. See "Vertical indices" in
   * HorizonText.md. Unit: that of z. Range: finite, at least 0. Default: 0.
   *
   * The default is the median of the nonzero differences in z between neighbouring columns, rounded to 1, 2 or 5 times
   * a power of ten; 1 if there are none.
   */
  vtkHorizonNumberMacro(VerticalStep, double);

  /**
   * Direction of increasing z: Down for depth and time, Up for elevation. Automatic: Up by format, name or sign of z,
   * else Down. See "Vertical direction" in HorizonText.md. Default: Automatic.
   *
   * The description has the direction and the reason; if most z, but not all, are negative, there is a warning.
   */
  vtkHorizonChoice3Macro(VerticalDirection, VerticalSense, Down, Up, Automatic);

  /**
   * Unit of z: ms, s, m or ft; no conversion. Empty: as in the data. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalUnit);

  /**
   * Time or depth. Empty: as in the data. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(VerticalDomain);

  /**
   * Unit of x and y: m or ft; no conversion. Empty: as in the data. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(HorizontalUnit);

  /**
   * Coordinate system; no conversion. Empty: as in the data. Range: any text. Default: empty.
   */
  vtkHorizonTextMacro(CoordinateSystem);

  /// What was found in the data. Empty before the first update.
  const char* GetDescription() { return this->Description.c_str(); }

protected:
  vtkSurveyHorizonSource();
  ~vtkSurveyHorizonSource() override;

  void CheckParameters() override;

  std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor) override;

  /// Horizons are in the order of the list.
  virtual SeismicHorizons::SurveyHorizons ReadSurvey(const SeismicHorizons::Monitor& monitor) = 0;

  /// Applies to data that state the direction of z.
  bool IsUpright(const SeismicHorizons::SurveyDescription& survey) const;

  virtual std::string DescribeFormat() { return std::string(); }

private:
  vtkSurveyHorizonSource(const vtkSurveyHorizonSource&) = delete;
  void operator=(const vtkSurveyHorizonSource&) = delete;

  double VerticalStep = 0.0;
  int VerticalDirection = Automatic;
  char* VerticalUnit = nullptr;
  char* VerticalDomain = nullptr;
  char* HorizontalUnit = nullptr;
  char* CoordinateSystem = nullptr;
  std::string Description;
};

#endif
