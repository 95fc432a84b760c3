// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonFromImage
 * @brief   makes a horizon from a map (an image with z as an array)
 *
 * The input is a vtkImageData of one layer, turned or not, as from ParaView's readers of GeoTIFF, BAG and DEM files.
 * Its points are the columns of the lattice, or the centres of its cells where z is an array of these. Columns that are
 * blanked, nan or have a null value are left out. Other arrays of one component become attributes.
 *
 * @sa vtkHorizonGridReader vtkHorizonFromPoints
 */

#ifndef vtkHorizonFromImage_h
#define vtkHorizonFromImage_h

#include "vtkHorizonProperty.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkSurveyHorizonSource.h"

class VTKSEISMICHORIZONS_EXPORT vtkHorizonFromImage : public vtkSurveyHorizonSource
{
public:
  static vtkHorizonFromImage* New();
  vtkTypeMacro(vtkHorizonFromImage, vtkSurveyHorizonSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Array with z, of points or cells. Empty: the active scalars, else the first one-component array, points first.
   * Range: a name. Default: empty.
   */
  vtkHorizonTextMacro(ZArray);

  /**
   * Numbers that mean no value, besides nan, infinity and 1e20 or more. Points without z are skipped. Unit: that of z.
   * Range: numbers, separated by blanks or commas. Default: empty.
   */
  vtkHorizonTextMacro(NullValues);

  ///@{
  /**
   * The map.
   */
  vtkHorizonInputMacro();
  ///@}

protected:
  vtkHorizonFromImage();
  ~vtkHorizonFromImage() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  std::vector<std::string> ListHorizons(const SeismicHorizons::Monitor& monitor) override;
  SeismicHorizons::SurveyHorizons ReadSurvey(const SeismicHorizons::Monitor& monitor) override;

private:
  vtkHorizonFromImage(const vtkHorizonFromImage&) = delete;
  void operator=(const vtkHorizonFromImage&) = delete;

  char* ZArray = nullptr;
  char* NullValues = nullptr;
};

#endif
