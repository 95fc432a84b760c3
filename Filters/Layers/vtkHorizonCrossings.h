// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCrossings
 * @brief   puts crossing horizons in order, column by column
 *
 * Input: as of vtkHorizonStackStage. Output: the same horizons, the uppermost first, with all points and all arrays
 * but RealZ; where horizons cross, points are moved up or down. Horizons that merge have bitwise identical z, and
 * points that are not moved keep theirs. Point data: Moved (double), how far a point was moved upwards, in the unit of
 * z. Field data: MovedColumns (vtkIdType) and FarthestMove (double).
 *
 * The repair is exact in each column: the ordered heights nearest to the given ones by least squares, or a running
 * minimum or maximum where one of two horizons wins. Errors: those of vtkHorizonLayers.
 *
 * @sa vtkHorizonLayers
 */

#ifndef vtkHorizonCrossings_h
#define vtkHorizonCrossings_h

#include "vtkHorizonStackStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <string> // for the results

class VTKSEISMICHORIZONS_EXPORT vtkHorizonCrossings : public vtkHorizonStackStage
{
public:
  static vtkHorizonCrossings* New();
  vtkTypeMacro(vtkHorizonCrossings, vtkHorizonStackStage);

  /**
   * Columns where neighbours crossed, and where each horizon was moved.
   *
   * Lines of text. Empty before the first update, and after an error.
   */
  const char* GetResults() { return this->Results.c_str(); }

protected:
  vtkHorizonCrossings() = default;
  ~vtkHorizonCrossings() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonCrossings(const vtkHorizonCrossings&) = delete;
  void operator=(const vtkHorizonCrossings&) = delete;

  std::string Results;
};

#endif
