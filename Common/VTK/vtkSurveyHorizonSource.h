// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurveyHorizonSource
 * @brief   base of what makes horizons of data with z alone: their vertical indices, units and names
 *
 * Each horizon becomes a vtkPolyData with one point and one vertex cell for each column that has a z: what the stages
 * work on. World x and y are those of the column, world z is z, or its negative where that counts downwards.
 *
 * The thresholds of the stages are in lattice units, of which the vertical step is one, so that z becomes vertical
 * indices, too: index 0 is the multiple of the step at the least z, or just below; with VerticalStep 0 each horizon has a
 * step and an index 0 of its own, else all have the same.
 *
 * Point data, one component each:
 * - SurfaceId (int): the number of the horizon, from 1
 * - VerticalIndex (int): the nearest vertical index; the active scalars
 * - RealZ (double): z as it came
 * - attributes (double) under their own names, but for one named PointCount; nan where there is none
 *
 * Field data, one tuple each:
 * - LatticeDimensions (int, 3 components), LatticeToWorld (double, 16 components), VerticalDirection (int): as from
 *   vtkVerneySparseMatrixReader
 * - LineNumbers (double, 4 components): the first inline, its step from a row to the next, the first crossline, and its
 *   step from a column to the next; only where they are known
 * - LatticeDeviation (double): how far, in columns, a point was off its column at most
 * - DroppedDuplicates, DroppedNulls (vtkIdType): points left out because another one is in their column, and because
 *   they have no z
 * - VerticalUnit, VerticalDomain, HorizontalUnit, CoordinateSystem (string): where the data or the user say so
 *
 * @sa vtkHorizonTextReader vtkHorizonGridReader vtkHorizonFromPoints vtkHorizonFromImage
 */

#ifndef vtkSurveyHorizonSource_h
#define vtkSurveyHorizonSource_h

#include "vtkHorizonSource.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

namespace SeismicHorizons
{
struct SurveyHorizons;
}

class VTKSEISMICHORIZONS_EXPORT vtkSurveyHorizonSource : public vtkHorizonSource
{
public:
  vtkTypeMacro(vtkSurveyHorizonSource, vtkHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The length of a vertical index, the unit of errors and thresholds. 0: chosen for each horizon, the rounded median
   * of the differences in z between neighbouring columns. See "Vertical indices" in HorizonTextReader.md. Unit: that
   * of z. Range: finite, at least 0. Default: 0.
   *
   * The median is of the differences that are not 0, rounded to the nearest of 1, 2 and 5 times a power of ten; 1 where
   * there are none.
   */
  vtkSetMacro(VerticalStep, double);
  vtkGetMacro(VerticalStep, double);
  ///@}

  /// Values of VerticalDirection.
  enum VerticalSense
  {
    Down = 0,
    Up = 1,
    Automatic = 2
  };

  ///@{
  /**
   * The direction in which z of the data increases. Down: world z decreases with it, as for time and depth. Up: world
   * z increases with it, as for elevation, which is negative below the sea. Automatic: Up for elevations by their
   * format, as images from GeoTIFF, BAG and DEM files, else Down. Default: Automatic.
   *
   * Other data mostly do not say, and it is not guessed; where all z are negative and the direction is down there is a
   * warning.
   */
  vtkSetClampMacro(VerticalDirection, int, Down, Automatic);
  vtkGetMacro(VerticalDirection, int);
  void SetVerticalDirectionToDown() { this->SetVerticalDirection(Down); }
  void SetVerticalDirectionToUp() { this->SetVerticalDirection(Up); }
  void SetVerticalDirectionToAutomatic() { this->SetVerticalDirection(Automatic); }
  ///@}

  ///@{
  /**
   * The unit of z for the field data: ms, s, m or ft, without conversion. Empty: as in the data. Range: any text.
   * Default: empty.
   */
  vtkSetStringMacro(VerticalUnit);
  vtkGetStringMacro(VerticalUnit);
  ///@}

  ///@{
  /**
   * Whether z is time or depth, for the field data, without conversion. Empty: as in the data. Range: any text.
   * Default: empty.
   */
  vtkSetStringMacro(VerticalDomain);
  vtkGetStringMacro(VerticalDomain);
  ///@}

  ///@{
  /**
   * The unit of x and y for the field data: m or ft, without conversion. Empty: as in the data. Range: any text.
   * Default: empty.
   */
  vtkSetStringMacro(HorizontalUnit);
  vtkGetStringMacro(HorizontalUnit);
  ///@}

  ///@{
  /**
   * The name of the coordinate system of x and y, for the field data, without conversion. Empty: as in the data.
   * Range: any text. Default: empty.
   */
  vtkSetStringMacro(CoordinateSystem);
  vtkGetStringMacro(CoordinateSystem);
  ///@}

  /// What was found in the data: format and columns, lattice, and vertical indices. Empty before the first update.
  const char* GetDescription() { return this->Description.c_str(); }

protected:
  vtkSurveyHorizonSource();
  ~vtkSurveyHorizonSource() override;

  void CheckParameters() override;

  std::vector<vtkSmartPointer<vtkDataObject>> MakeHorizons(
    const std::vector<int>& numbers, const SeismicHorizons::Monitor& monitor) override;

  /// All horizons, in the order of their list.
  virtual SeismicHorizons::SurveyHorizons ReadSurvey(const SeismicHorizons::Monitor& monitor) = 0;

  /// The format of the data, for the description.
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
