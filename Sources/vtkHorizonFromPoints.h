// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonFromPoints
 * @brief   makes horizons from points or a table, on the lattice of their survey
 *
 * The input is a vtkPointSet or a vtkTable, as from ParaView's readers of CSV or LAS files, or from a Calculator. The
 * coordinates of points are x, y and z. Other arrays, and those of a table, are taken by their names: "X" or "Easting",
 * "Y" or "Northing", "Z", "Depth" or "Time", "Inline" or "IL", "Crossline" or "XL", "Name" or "Horizon" and the like
 * (Documentation/HorizonSources.md has all); or by those that the properties give. Other numbers become attributes;
 * arrays of several components become one for each, "Normals_0" and so on. Ghost points are left out.
 *
 * @sa vtkHorizonTextReader vtkHorizonFromImage
 */

#ifndef vtkHorizonFromPoints_h
#define vtkHorizonFromPoints_h

#include "vtkHorizonProperty.h"
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

  /**
   * Array with x. Empty: the coordinates of points, or an array with a usual name. Range: a name. Default: empty.
   *
   * A named array must exist, here and below.
   */
  vtkHorizonTextMacro(XArray);

  /**
   * Array with y. Empty: as for x. Range: a name. Default: empty.
   */
  vtkHorizonTextMacro(YArray);

  /**
   * Array with z. Empty: as for x. Range: a name. Default: empty.
   */
  vtkHorizonTextMacro(ZArray);

  /**
   * Inline numbers. Empty: an array with a usual name, if any. Range: a name. Default: empty.
   */
  vtkHorizonTextMacro(InlineArray);

  /**
   * Crossline numbers. Empty: an array with a usual name, if any. Range: a name. Default: empty.
   */
  vtkHorizonTextMacro(CrosslineArray);

  /**
   * Horizon names, numbers or text. Empty: an array called name or horizon, else all are Horizon 1. Range: a name.
   * Default: empty.
   */
  vtkHorizonTextMacro(NameArray);

  /**
   * Numbers that mean no value, besides nan, infinity and 1e20 or more. Points without z are skipped. Unit: that of z.
   * Range: numbers, separated by blanks or commas. Default: empty.
   */
  vtkHorizonTextMacro(NullValues);

  ///@{
  /**
   * The points or the table.
   */
  vtkHorizonInputMacro();
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

  std::unique_ptr<SeismicHorizons::PickTable> Picks; // Set from listing horizons until they are made.
  vtkTimeStamp PickTime;
};

#endif
