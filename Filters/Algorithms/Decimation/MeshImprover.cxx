// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshImprover.h"

#include "EdgeFlips.h"
#include "HeightFit.h"
#include "MeshCost.h"
#include "MoveLimit.h"
#include "VertexRemoval.h"

namespace SeismicHorizons
{
namespace
{
// Each finds less: the third takes one vertex in a hundred.
constexpr int Rounds = 3;
}

//----------------------------------------------------------------------------------------------------------------------
void ImproveWithinError(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  const double error = options.MaximumError;
  MeshCost cost(DecimationPriority::LargestError, error, options.SmallestAngle);
  cost.LargestError = error + mesh.Rounding();
  mesh.Triangles().SortByPlace();
  for (int round = 0; round < Rounds; ++round)
  {
    const Monitor step = monitor.Step(double(round) / Rounds, double(round + 1) / Rounds);
    FlipEdges(mesh, cost, step.Step(0.0, 0.3));
    if (options.FitHeights)
    {
      MoveHeightsWithin(
        mesh, cost.LargestError, FitHeights(mesh, DecimationPriority::LargestError, error, step.Step(0.3, 0.5)));
    }
    RemoveVertices(mesh, cost, 0, step.Step(0.5, 1.0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ReduceToNumber(HeightMesh& mesh, std::size_t vertices, const DecimationOptions& options, const Monitor& monitor)
{
  const double largest = mesh.LargestError();
  mesh.Triangles().SortByPlace();
  MeshCost cost(options.Priority, largest > 0.0 ? largest : 1.0, options.SmallestAngle);
  FlipEdges(mesh, cost, monitor.Step(0.0, 0.2));
  if (options.FitHeights)
  {
    FitToNumber(mesh, options.Priority, monitor.Step(0.2, 0.3));
  }
  RemoveVertices(mesh, cost, vertices, monitor.Step(0.3, 0.7));
  cost.SmallestSine = 0.0;
  RemoveVertices(mesh, cost, vertices, monitor.Step(0.7, 0.75)); // where angles were in the way
  FlipEdges(mesh, cost, monitor.Step(0.75, 0.9));
  if (options.FitHeights)
  {
    FitToNumber(mesh, options.Priority, monitor.Step(0.9, 1.0));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FitToNumber(HeightMesh& mesh, DecimationPriority priority, const Monitor& monitor)
{
  const double largest = mesh.LargestError();
  const InnerHeights heights = FitHeights(mesh, priority, largest, monitor);
  if (priority == DecimationPriority::LargestError)
  {
    MoveHeightsWithin(mesh, largest, heights);
    return;
  }
  const InnerHeights before = mesh.Heights();
  const double sum = mesh.SumOfErrors();
  mesh.SetHeights(heights);
  if (mesh.SumOfErrors() > sum)
  {
    mesh.SetHeights(before);
  }
}
}
