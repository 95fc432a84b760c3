// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonThickness
 * @brief   measures the thickness of the layer between two horizons, column by column
 *
 * Input 0: a horizon, or a composite dataset of horizons, with at most one point per column. Input 1, or a second
 * connection of input 0: the other horizon, with points on columns of the same lattice; a window of the survey, or
 * every second line, is enough. Without it, each of two horizons at input 0 is measured to the other, even if they are
 * on different processes. Either may be a mesh: then it is measured in the columns that its triangles cover.
 *
 * Output 0: the points of input 0 in columns where the other horizon has one, a vertex cell per point, all arrays but
 * PatchId and Boundary (of a mesh, points in these columns on its triangles, with Column alone), and the point arrays
 *  - Isochore (double): the vertical thickness, in the unit of z; negative where the horizons cross;
 *  - Isopach (double): the true thickness, at a right angle to the surface half-way between the horizons; nan where the
 *    dip is unknown. There is none if VerticalDomain is time, or if the units of z and of x and y differ.
 *
 * Field data: IsochoreLeast, IsochoreMean, IsochoreLargest (double); IsochoreVolume (double, with Isopach only), the
 * sum over columns, each with its area, crossings as 0; IsochoreCrossings (vtkIdType), columns where the order is not
 * that of most columns; and LedgerColumns and LedgerArea: Known are columns of both, LeftOut those of one alone. Where a
 * horizon is on every second line, a column stands for two in the volume and in the ledger.
 *
 * Output 1, the map: a vtkImageData for each horizon, with a pixel at z = 0 for each column of the bounding box and the
 * same arrays, blanked and nan where there is no thickness. Empty, with a warning, if the steps of the lattice are not
 * perpendicular, as images have no shear, and if the box is nearly empty and has more than 2^24 pixels.
 *
 * A warning if more than one column in twenty is a crossing, or more than one in a thousand left out. Errors: not
 * exactly one other horizon, a point of it between columns, two in one column, or no common column.
 *
 * @sa vtkHorizonSurface, whose mesh carries both arrays
 */

#ifndef vtkHorizonThickness_h
#define vtkHorizonThickness_h

#include "vtkHorizonAlgorithm.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro
#include "vtkSmartPointer.h" // for a member

#include <vector> // for a member

class vtkDataObject;
class vtkImageData;

class VTKSEISMICHORIZONS_EXPORT vtkHorizonThickness : public vtkHorizonAlgorithm
{
public:
  static vtkHorizonThickness* New();
  vtkTypeMacro(vtkHorizonThickness, vtkHorizonAlgorithm);

  ///@{
  /**
   * Other horizon, above or below; optional if the input has two. Range: points or a mesh. Default: none.
   *
   * Input 1.
   */
  void SetOtherConnection(vtkAlgorithmOutput* other) { this->SetInputConnection(1, other); }
  void RemoveOther() { this->SetInputConnection(1, nullptr); }
  ///@}

  /// The map of a single horizon; null when it is a composite dataset.
  vtkImageData* GetMap();

protected:
  vtkHorizonThickness();
  ~vtkHorizonThickness() override = default;

  void ProcessHorizon(
    const SeismicHorizons::Horizon& horizon, Outputs& outputs, const SeismicHorizons::Monitor& monitor) override;
  bool TakesMeshes() override { return true; }
  void ShareHorizons(const std::vector<SeismicHorizons::HorizonLeaf>& own,
    const std::vector<SeismicHorizons::RankedHorizon>& all, const SeismicHorizons::Ranks& ranks) override;
  int GetNumberOfHorizonPorts() override { return 1; }
  void ProcessOutputs(const std::vector<vtkDataObject*>& outputs) override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDataObject* GetOther();

  vtkHorizonThickness(const vtkHorizonThickness&) = delete;
  void operator=(const vtkHorizonThickness&) = delete;

  /// candidates for the other horizon
  std::vector<vtkSmartPointer<vtkPolyData>> Others;
};

#endif
