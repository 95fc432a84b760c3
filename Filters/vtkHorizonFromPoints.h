// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonFromPoints
 * @brief   makes horizons of any points or table: puts them on the lattice they stand on
 *
 * The input is a vtkPointSet or a vtkTable, as from ParaView's readers of CSV or LAS files, or from a Calculator. The
 * coordinates of points are x, y and z. Other arrays, and those of a table, are taken by their names: "X" or "Easting",
 * "Y" or "Northing", "Z", "Depth" or "Time", "Inline" or "IL", "Crossline" or "XL", "Name" or "Horizon" and the like
 * (Documentation/HorizonFromPoints.md has all); or by those that the properties give. Other numbers become attributes;
 * arrays of several components become one for each, "Normals_0" and so on. Ghost points are left out.
 *
 * @sa vtkHorizonTextReader vtkHorizonFromImage
 */

#ifndef vtkHorizonFromPoints_h
#define vtkHorizonFromPoints_h

#include "vtkPickHorizonSource.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkTimeStamp.h" // for the points

#include <memory> // for std::unique_ptr

class VTKSEISMICHORIZONS_EXPORT vtkHorizonFromPoints : public vtkPickHorizonSource
{
public:
  static vtkHorizonFromPoints* New();
  vtkTypeMacro(vtkHorizonFromPoints, vtkPickHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The names of the arrays with x, y, z, inline, crossline, and the name of the horizon. An array that is named has to
   * be there. Default: empty, for the coordinates of points, and for arrays by their usual names.
   */
  vtkSetStringMacro(XArray);
  vtkGetStringMacro(XArray);
  vtkSetStringMacro(YArray);
  vtkGetStringMacro(YArray);
  vtkSetStringMacro(ZArray);
  vtkGetStringMacro(ZArray);
  vtkSetStringMacro(InlineArray);
  vtkGetStringMacro(InlineArray);
  vtkSetStringMacro(CrosslineArray);
  vtkGetStringMacro(CrosslineArray);
  vtkSetStringMacro(NameArray);
  vtkGetStringMacro(NameArray);
  ///@}

  ///@{
  /**
   * Numbers that stand for "no value", separated by blanks or commas. Besides these, nan, infinity and numbers of 1e30
   * and more do so always. Points without z are left out, attributes become nan. Default: empty.
   */
  vtkSetStringMacro(NullValues);
  vtkGetStringMacro(NullValues);
  ///@}

protected:
  vtkHorizonFromPoints();
  ~vtkHorizonFromPoints() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  std::vector<std::string> ListNames(const SeismicHorizons::Monitor& monitor) override;
  std::vector<std::int64_t> CountPicks() override;
  vtkMTimeType GetPickTime() override;
  SeismicHorizons::PickTable ReadPicks(const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonFromPoints(const vtkHorizonFromPoints&) = delete;
  void operator=(const vtkHorizonFromPoints&) = delete;

  char* XArray = nullptr;
  char* YArray = nullptr;
  char* ZArray = nullptr;
  char* InlineArray = nullptr;
  char* CrosslineArray = nullptr;
  char* NameArray = nullptr;
  char* NullValues = nullptr;

  std::unique_ptr<SeismicHorizons::PickTable> Picks; // between the list of horizons and their making
  vtkTimeStamp PickTime;
};

#endif
