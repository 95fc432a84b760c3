// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonSurface.h"

#include "Common/VTK/RankedHorizons.h"
#include "Common/VTK/Ranks.h"
#include "Filters/Algorithms/Surface/RankedParts.h"
#include "Filters/Algorithms/Surface/SurfaceParts.h"
#include "SurfaceStage.h"

#include "vtkObjectFactory.h"

#include <exception>
#include <optional>

using namespace SeismicHorizons;

namespace
{
template <typename Value, typename Given>
std::optional<Value> UnlessAutomatic(bool isAutomatic, Given value)
{
  return isAutomatic ? std::nullopt : std::optional<Value>(value);
}

/// The ranks, numbered from that of the horizon.
class RanksOfHorizon : public PartRanks
{
public:
  RanksOfHorizon(const Ranks& ranks, int first)
    : All(ranks)
    , First(first)
  {
  }

  int Size() const override { return this->All.Size(); }
  int Own() const override { return (this->All.Own() - this->First + this->Size()) % this->Size(); }
  ByteBuffer Receive(int rank) const override { return ByteBuffer(this->All.ReceiveBytes(this->RankOf(rank))); }
  void Together(const std::function<void()>& work) const override { this->All.Together(work); }

protected:
  void SendTo(int rank, const ByteBuffer& bytes) const override { this->All.Send(bytes.Bytes(), this->RankOf(rank)); }

private:
  int RankOf(int number) const { return (number + this->First) % this->Size(); }

  const Ranks& All;
  const int First;
};
}

vtkStandardNewMacro(vtkHorizonSurface);

//------------------------------------------------------------------------------
vtkHorizonSurface::vtkHorizonSurface()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkHorizonSurface::ProcessHorizon(const Horizon& horizon, Outputs& outputs, const Monitor& monitor)
{
  SurfaceStageOptions options;
  static_cast<ReducedMeshOptions&>(options) = this->MakeMeshOptions(this->Target == LargestError);
  if (this->Target == NumberOfTriangles)
  {
    options.MaximumNumberOfTriangles = this->MaximumNumberOfTriangles;
  }
  options.Radius = UnlessAutomatic<int>(this->AutomaticRadius, this->Radius);
  options.Growth = static_cast<SeismicHorizons::GrowthStrategy>(this->GrowthStrategy);
  options.KeepHoles = this->KeepHoles;
  options.TearAtFaults = this->TearAtFaults;
  options.SmallestHoleSize = UnlessAutomatic<std::int64_t>(this->AutomaticSmallestHoleSize, this->SmallestHoleSize);
  options.MinimumPatchSize = this->MinimumPatchSize;
  options.OutlineTolerance = UnlessAutomatic<double>(this->AutomaticOutlineTolerance, this->OutlineTolerance);
  options.DistanceThreshold = UnlessAutomatic<double>(this->AutomaticDistanceThreshold, this->DistanceThreshold);
  options.Ranks = this->Helpers;
  this->Warn(RunSurface(horizon, options, outputs, monitor));
}

//------------------------------------------------------------------------------
// Horizons with so many points have several bands.
bool vtkHorizonSurface::IsForAllRanks(const RankedHorizon& horizon)
{
  return horizon.Points >= 2 * ColumnsOfBand && this->Target == LargestError && this->GetEffort() == Best;
}

//------------------------------------------------------------------------------
void vtkHorizonSurface::ProcessOnRanks(
  const RankedHorizon& horizon, const Ranks& ranks, const Monitor& monitor, const std::function<void()>& process)
{
  const RanksOfHorizon all(ranks, horizon.Rank);
  if (horizon.Rank != ranks.Own())
  {
    HelpToMesh(all, monitor);
    return;
  }
  this->Helpers = &all;
  std::exception_ptr problem;
  try
  {
    process();
  }
  catch (...)
  {
    problem = std::current_exception();
  }
  this->Helpers = nullptr;
  ReleaseHelpers(all);
  if (problem)
  {
    std::rethrow_exception(problem);
  }
}
