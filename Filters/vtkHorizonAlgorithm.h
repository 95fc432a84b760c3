// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHorizonAlgorithm
 * @brief   base class of stages that turn one horizon into another
 *
 * A horizon is a vtkPolyData with the lattice in its field data (see Documentation/DataModel.md). A stage takes one
 * horizon, or a composite dataset of horizons (any vtkDataObjectTree), and gives the same kind of dataset with the same
 * structure and names. A subclass only processes one horizon.
 *
 * A horizon without points gives an empty one. Stages that process points refuse meshes. If a horizon cannot be
 * processed, one error names it, and reports what was found and what was expected. The whole output is then empty,
 * even if other horizons were processed before; the same applies if the user stops it. With InvalidHorizons set to
 * LeaveOut, only that horizon is empty, with a warning. Progress goes from 0 to 1 over all horizons.
 *
 * Inputs after the first one are optional, and apply to all horizons: every process receives all of them.
 *
 * With several processes, each works on its horizons, and a horizon must have all its points on one process. An error
 * on one empties the output of all.
 *
 * @sa vtkHorizonExteriorBoundary vtkHorizonBoundarySimplification vtkHorizonCellSimplification vtkHorizonTriangulation
 * vtkHorizonSurfaceDistance
 */

#ifndef vtkHorizonAlgorithm_h
#define vtkHorizonAlgorithm_h

#include "vtkHorizonStage.h"
#include "vtkSeismicHorizonsModule.h" // for the export macro

#include <functional> // for work on several ranks
#include <string> // for the results
#include <vector> // for the outputs

namespace SeismicHorizons
{
class Monitor;
class Ranks;
struct Horizon;
struct HorizonLeaf;
struct RankedHorizon;
}
class vtkPolyData;

class VTKSEISMICHORIZONS_EXPORT vtkHorizonAlgorithm : public vtkHorizonStage
{
public:
  vtkTypeMacro(vtkHorizonAlgorithm, vtkHorizonStage);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Output 0 as a single horizon; null when it is a composite dataset.
  vtkPolyData* GetPolyDataOutput();

  /**
   * Points of each horizon before and after, and other figures.
   *
   * Lines of text. Each process has a text of its own horizons. Empty before the first update, and after an error;
   * after a stop they say so.
   */
  const char* GetResults() { return this->Results.c_str(); }

protected:
  vtkHorizonAlgorithm() = default;
  ~vtkHorizonAlgorithm() override = default;

  using Outputs = std::vector<SeismicHorizons::Horizon>;

  /// The outputs, by port, have only the field data of the input, which has visible points. Throws
  /// SeismicHorizons::InputError on unsuitable input.
  virtual void ProcessHorizon(
    const SeismicHorizons::Horizon& input, Outputs& outputs, const SeismicHorizons::Monitor& monitor);

  /// The same with datasets. A filter overrides one of the two.
  virtual void ProcessPolyData(
    vtkPolyData* input, const std::vector<vtkPolyData*>& outputs, const SeismicHorizons::Monitor& monitor);

  /// Stages refuse triangles unless they override this.
  virtual bool TakesMeshes() { return false; }

  /// Called before horizons are processed, with the horizons of this rank and of all ranks, for stages that need
  /// several at once. Collective.
  virtual void ShareHorizons(const std::vector<SeismicHorizons::HorizonLeaf>& own,
    const std::vector<SeismicHorizons::RankedHorizon>& all, const SeismicHorizons::Ranks& ranks);

  /// Whether ranks process a horizon together. The answer is the same on all.
  virtual bool IsForAllRanks(const SeismicHorizons::RankedHorizon&) { return false; }

  /// Calls process() on the rank of such a horizon, while others help. Collective.
  virtual void ProcessOnRanks(const SeismicHorizons::RankedHorizon& horizon, const SeismicHorizons::Ranks& ranks,
    const SeismicHorizons::Monitor& monitor, const std::function<void()>& process);

  /// The first ports have horizons; by default all have.
  virtual int GetNumberOfHorizonPorts() { return this->GetNumberOfOutputPorts(); }

  /// Fills the remaining outputs once all horizons are processed.
  virtual void ProcessOutputs(const std::vector<vtkDataObject*>& outputs);

  /// Warns of the horizon that is processed.
  void Warn(const std::string& text);
  void Warn(const std::vector<std::string>& texts);

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkHorizonAlgorithm(const vtkHorizonAlgorithm&) = delete;
  void operator=(const vtkHorizonAlgorithm&) = delete;

  Outputs Process(const SeismicHorizons::Horizon& given, const SeismicHorizons::HorizonLeaf& leaf,
    const SeismicHorizons::Monitor& monitor);

  std::string Results;
  std::string HorizonName; // of the horizon that is processed, or empty
};

#endif
