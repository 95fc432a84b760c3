// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellSimplificationStage.h"

#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Filters/Common/HorizonData.h"
#include "Filters/Common/HorizonPoints.h"
#include "Filters/Common/ReducedHorizon.h"

#include <array>
#include <utility>

namespace SeismicHorizons
{
namespace
{
/// A single line along the edges; for a box it retraces some of the 12 edges and takes 15 steps.
void AddOutline(const SimplificationCell& cell, bool isCube, const Lattice& lattice, HeapArray<double>& places,
  HeapArray<std::int64_t>& points, HeapArray<std::int64_t>& offsets)
{
  constexpr std::array<int, 16> edges = { 0, 1, 2, 3, 0, 4, 5, 1, 5, 6, 2, 6, 7, 3, 7, 4 }; // a square, then the rest
  const auto first = std::int64_t(places.size() / 3);
  for (int corner = 0; corner < (isCube ? 8 : 4); ++corner)
  {
    // Corners run around the bottom, then around the top.
    const bool right = corner % 4 == 1 || corner % 4 == 2;
    const bool back = corner % 4 >= 2;
    const Eigen::Vector3d steps(right ? 1.0 : 0.0, back ? 1.0 : 0.0, corner >= 4 ? 1.0 : 0.0);
    const Eigen::Vector3d low(cell.Low.X, cell.Low.Y, cell.Low.Z);
    const Eigen::Vector3d world = lattice.ToWorld(low + cell.Size * steps);
    places.append(world.data(), world.data() + 3);
  }
  for (std::size_t n = 0; n < (isCube ? edges.size() : 5); ++n)
  {
    points.push_back(first + edges[n]);
  }
  offsets.push_back(std::int64_t(points.size()));
}

void WriteCells(const Reduction& reduction, bool areCubes, const Lattice& lattice, Horizon& output)
{
  HeapArray<double> places;
  HeapArray<std::int64_t> points;
  HeapArray<std::int64_t> offsets = { 0 };
  for (const SimplificationCell& cell : reduction.Cells)
  {
    AddOutline(cell, areCubes, lattice, places, points, offsets);
  }
  output.Places = DataArray::Take(places, 3);
  output.Lines = { DataArray::Take(offsets), DataArray::Take(points) };
  ArrayTable& data = output.CellData;
  data.Add(
    MakeOrigins(reduction.Cells, [](const SimplificationCell& cell) -> const PointOrigin& { return cell.Origin; }));
  AddArray<double>(
    data, CellArray::CellSize, reduction.Cells, [](const SimplificationCell& cell) { return cell.Size; });
  AddArray<int>(data, PointArray::PatchId, reduction.Cells, [](const SimplificationCell& cell) { return cell.Patch; });
  AddArray<std::int64_t>(
    data, PointArray::PointCount, reduction.Cells, [](const SimplificationCell& cell) { return cell.Points; });
  if (!reduction.Flatness.empty())
  {
    AddArray<double>(
      data, PointArray::Flatness, reduction.Cells, [](const SimplificationCell& cell) { return cell.Flatness; });
  }
  data.SetActiveScalars(CellArray::CellSize);
}

/// Calls simplify(horizon, monitor).
template <typename Simplify>
void Run(const Horizon& horizon, bool showCells, bool areCubes, std::int64_t most, std::vector<Horizon>& outputs,
  const Monitor& monitor, Simplify&& simplify)
{
  CheckAtLeast<std::int64_t>("maximum number of points", most, 0, ", which stands for CellSize");
  LatticePoints points = ReadPoints(horizon);
  WriteDeviation(points, outputs);
  const Horizon input = points.Horizon;
  const Lattice lattice = points.Lattice;
  monitor.Progress(0.1);
  Horizon& output = outputs.front();
  // The bounded horizon is freed before the output is made.
  Reduction reduction = simplify(ReadBoundedHorizon(std::move(points)), monitor.Step(0.2, 0.8));
  if (showCells)
  {
    WriteCells(reduction, areCubes, lattice, output);
    return;
  }
  output.Places = MakePoints(input, lattice, reduction);
  reduction.Plane = std::vector<PlanePoint>(); // This frees memory for the arrays.
  reduction.Height = std::vector<double>();
  WriteReduction(input, reduction, output);
  ActivateHeight(output);
}
}

//----------------------------------------------------------------------------------------------------------------------
void RunRoughSimplification(
  const Horizon& horizon, CellOptions options, std::int64_t most, std::vector<Horizon>& outputs, const Monitor& monitor)
{
  Run(horizon, options.ListCells, false, most, outputs, monitor,
    [&](const BoundedHorizon& bounded, const Monitor& step)
    {
      if (most == 0)
      {
        return SimplifyRough(bounded, options, step);
      }
      Reduction reduction = SimplifyRoughTo(std::size_t(most), bounded, options, step);
      AddValue<int>(outputs.front().FieldData, FieldArray::ChosenCellSize, options.CellSize);
      return reduction;
    });
}

//----------------------------------------------------------------------------------------------------------------------
void RunElaborateSimplification(const Horizon& horizon, ElaborateOptions options, std::int64_t most,
  std::vector<Horizon>& outputs, const Monitor& monitor)
{
  Run(horizon, options.ListCells, true, most, outputs, monitor,
    [&](const BoundedHorizon& bounded, const Monitor& step)
    {
      if (most == 0)
      {
        return SimplifyElaborate(bounded, options, step);
      }
      Reduction reduction = SimplifyElaborateTo(std::size_t(most), bounded, options, step);
      ArrayTable& chosen = outputs.front().FieldData;
      AddValue<int>(chosen, FieldArray::ChosenCellSize, options.CellSize);
      AddValue<double>(chosen, FieldArray::ChosenFlatnessThreshold, options.FlatnessThreshold);
      return reduction;
    });
}
}
