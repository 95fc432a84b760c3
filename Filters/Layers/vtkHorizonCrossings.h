// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonCrossings
 * @brief   puts horizons that cross in order, column by column
 *
 * Input: as of vtkHorizonStackStage. Output: the same horizons, the uppermost first, with all points and all arrays but
 * RealZ; where horizons cross, points are moved up or down. Horizons that become one get the same z, to the bit, and
 * points that stay keep theirs. Point data: Moved (double), how far a point was moved upwards, in the unit of z. Field
 * data: MovedColumns (vtkIdType) and FarthestMove (double).
 *
 * The repair is exact in each column: the heights in order that are nearest to the given ones, by squares, or a running
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
   * What the last update did: of each pair of neighbours the columns where they crossed, and of each horizon those that
   * were moved.
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
