// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurveyHorizonSource
 * @brief   base of what makes horizons of data with z alone: their vertical indices, units and names
 *
 * Each horizon becomes a vtkPolyData with one point and one vertex cell for each column that has a z: what the stages
 * work on. World x and y are those of the column, world z is z with the sign of VerticalDirection.
 *
 * The thresholds of the stages are in lattice units, of which the vertical step is one, so that z becomes vertical
 * indices, too: index 0 is the multiple of VerticalStep at the least z of all horizons, or just below.
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
   * The length of a vertical index, in the unit of z. 0: one that suits the data, which is the median of the
   * differences in z between neighbouring columns where they differ, rounded to the nearest of 1, 2 and 5 times a power
   * of ten; 1 where there are none. It is found for all horizons together, whether they are selected or not. Finite, at
   * least 0. Default: 0.
   */
  vtkSetMacro(VerticalStep, double);
  vtkGetMacro(VerticalStep, double);
  ///@}

  /// Where z grows to.
  enum VerticalSense
  {
    Down = 0,
    Up = 1
  };

  ///@{
  /**
   * Where z grows to. Down: to smaller world z, as time and depth do. Up: to larger world z, as elevation does. Data
   * mostly do not say, and it is not guessed; where all z are negative and the direction is Down there is a warning.
   * Default: Down.
   */
  vtkSetClampMacro(VerticalDirection, int, Down, Up);
  vtkGetMacro(VerticalDirection, int);
  void SetVerticalDirectionToDown() { this->SetVerticalDirection(Down); }
  void SetVerticalDirectionToUp() { this->SetVerticalDirection(Up); }
  ///@}

  ///@{
  /**
   * What is put into the field data: the unit of z ("ms", "s", "m", "ft"), whether z is "time" or "depth", the unit of
   * x and y, and the name of their coordinate system. They change no number. Default: empty, for what the data say.
   */
  vtkSetStringMacro(VerticalUnit);
  vtkGetStringMacro(VerticalUnit);
  vtkSetStringMacro(VerticalDomain);
  vtkGetStringMacro(VerticalDomain);
  vtkSetStringMacro(HorizontalUnit);
  vtkGetStringMacro(HorizontalUnit);
  vtkSetStringMacro(CoordinateSystem);
  vtkGetStringMacro(CoordinateSystem);
  ///@}

  /**
   * What was found in the data, for people: lines of text about their format, lattice and vertical indices. Empty
   * before the first update.
   */
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
  int VerticalDirection = Down;
  char* VerticalUnit = nullptr;
  char* VerticalDomain = nullptr;
  char* HorizontalUnit = nullptr;
  char* CoordinateSystem = nullptr;
  std::string Description;
};

#endif
