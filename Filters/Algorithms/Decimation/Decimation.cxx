// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Decimation.h"

#include "Common/Parameters.h"
#include "EdgeFlips.h"
#include "HeightFit.h"
#include "MeshRefiner.h"
#include "MeshResult.h"
#include "VertexRemoval.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace SeismicHorizons
{
namespace
{
std::vector<PlanePoint> ToColumns(const BoundedHorizon& horizon)
{
  std::vector<PlanePoint> columns;
  columns.reserve(horizon.Plane.size());
  for (const PlanePoint& place : horizon.Plane)
  {
    if (place.X % horizon.SubVoxelsPerColumn != 0 || place.Y % horizon.SubVoxelsPerColumn != 0)
    {
      throw InputError("point " + std::to_string(columns.size()) +
        " stands beside its column, expected whole columns: horizons are decimated before points are merged");
    }
    columns.push_back({ place.X / horizon.SubVoxelsPerColumn, place.Y / horizon.SubVoxelsPerColumn });
  }
  return columns;
}

// With fitted heights, points are inserted for an error so much larger, and then, once heights are fitted, for the
// error itself. What was not fitted again then needs some room: heights move less than the error.
constexpr double ErrorBeforeFit = 1.3;
constexpr double ReachOfFit = 0.9;

class Decimator
{
public:
  Decimator(HeightMesh& mesh, const DecimationOptions& options)
    : Mesh(mesh)
    , Options(options)
  {
  }

  void Run(const Monitor& monitor)
  {
    if (this->Options.Effort == DecimationEffort::Fast)
    {
      this->RunFast(monitor);
    }
    else if (this->Options.MaximumError > 0.0)
    {
      this->RunBestToError(monitor);
    }
    else
    {
      this->RunBestToNumber(monitor);
    }
  }

private:
  void RunFast(const Monitor& monitor)
  {
    const double error = this->Options.MaximumError;
    MeshRefiner refiner(this->Mesh, this->Options.MaximumNumberOfPoints);
    if (this->Options.FitHeights && error > 0.0)
    {
      refiner.InsertWhereFar(ErrorBeforeFit * error, monitor.Step(0.0, 0.48));
      this->Fit(FitTarget::LargestError, error, monitor.Step(0.48, 0.6));
    }
    else if (this->Options.FitHeights)
    {
      refiner.InsertWhereFar(0.0, monitor.Step(0.0, 0.48));
      this->FitMean(refiner.FindLargest(), monitor.Step(0.48, 0.6));
    }
    refiner.InsertWhereFar(error, monitor.Step(this->Options.FitHeights ? 0.6 : 0.0, 0.8));
    refiner.InsertAtSides(error, monitor.Step(0.8, 1.0));
  }

  void Fit(FitTarget target, double error, const Monitor& monitor)
  {
    if (this->Options.FitHeights)
    {
      this->Mesh.SetHeights(FitHeights(this->Mesh, target, ReachOfFit * error, monitor));
    }
  }

  /// Heights that are whole numbers can fit best as they are: many points then lie right on the mesh.
  void FitMean(double reach, const Monitor& monitor)
  {
    const double before = this->Mesh.SumOfErrors();
    this->Mesh.SetHeights(FitHeights(this->Mesh, FitTarget::MeanError, reach, monitor));
    if (this->Mesh.SumOfErrors() > before)
    {
      this->Mesh.SetHeights(this->Mesh.Input().Height);
    }
  }

  void RunBestToError(const Monitor& monitor)
  {
    const double error = this->Options.MaximumError;
    const auto env=[](const char*n,double d){ const char*v=getenv(n); return v?atof(v):d; };
    const bool v = getenv("VERB");
    MeshCost cost;
    cost.Power.Unit = error;
    cost.Power.Power = int(env("POW",4));
    cost.SmallestSine = std::sin(this->Options.SmallestAngle * M_PI / 180.0);
    cost.LargestError = error*env("FE",1.0);
    MeshCost rcost = cost; rcost.SmallestSine = std::sin(env("RANG",this->Options.SmallestAngle) * M_PI / 180.0); rcost.LargestError = error*env("RE",1.0);
    MeshRefiner r0(this->Mesh, 0);
    r0.InsertWhereFar(env("EBF",1.3) * error, monitor.Step(0.0, 0.2));
    EdgeFlips flips(this->Mesh, cost);
    if(env("START",0)>0) {
      this->Fit(FitTarget::LargestError, error, Monitor());
      r0.InsertWhereFar(error, Monitor());
      r0.InsertAtSides(error, Monitor());
    } else {
    flips.Run(Monitor());
    this->Fit(FitTarget::LargestError, error, Monitor());
    if(v) printf("  inserted %zu\n", this->Mesh.NumberOfVertices());
    MeshRefiner refiner(this->Mesh, 0, &flips, cost.Power);
    refiner.InsertWhereFar(error, Monitor());
    if(v) printf("  inserted %zu\n", this->Mesh.NumberOfVertices());
    refiner.InsertAtSides(error, Monitor());
    }
    if(v) printf("  inserted %zu\n", this->Mesh.NumberOfVertices());
    const int rounds = int(env("ROUNDS",2));
    for (int round = 0; round < rounds; ++round)
    {
      flips.Run(Monitor());
      if (this->Options.FitHeights)
      {
        const std::vector<double> before = this->Mesh.Heights();
        this->Fit(FitTarget::LargestError, error, Monitor());
        LimitMoves(this->Mesh, before, error);
      }
      VertexRemoval(this->Mesh, rcost).Run(0, Monitor());
      if(v) printf("  removed to %zu\n", this->Mesh.NumberOfVertices());
    }
    flips.Run(Monitor());
      if (this->Options.FitHeights)
      {
        const std::vector<double> before = this->Mesh.Heights();
        this->Fit(FitTarget::LargestError, error, Monitor());
        LimitMoves(this->Mesh, before, error);
      }
    MeshRefiner refiner(this->Mesh, 0, &flips, cost.Power);
    refiner.InsertWhereFar(error, Monitor());
    refiner.InsertAtSides(error, Monitor());
    if(v) printf("  inserted %zu\n", this->Mesh.NumberOfVertices());
  }

  void RunBestToNumber(const Monitor& monitor)
  {
    const std::size_t number = this->Options.MaximumNumberOfPoints;
    const auto env=[](const char*n,double d){ const char*v=getenv(n); return v?atof(v):d; };
    const std::size_t loops = this->Mesh.NumberOfVertices();
    const auto part = [&](double f) { return loops + std::size_t(f * double(number - loops)); };
    const bool v = getenv("VERB");
    MeshRefiner first(this->Mesh, part(env("OVER",1.3)));
    first.InsertWhereFar(0.0, monitor.Step(0.0, 0.2));
    MeshCost cost;
    cost.Power.Power = int(env("POW",4));
    cost.Power.Unit = std::max(first.FindLargest(), 1e-300);
    cost.SmallestSine = std::sin(this->Options.SmallestAngle * M_PI / 180.0);
    EdgeFlips flips(this->Mesh, cost);
    const int rounds = int(env("ROUNDS",2));
    for (int round = 0; round < rounds; ++round)
    {
      flips.Run(Monitor());
      this->Fit(cost.Power.Power==4?FitTarget::LargestError:FitTarget::MeanError, env("REACH",1)*cost.Power.Unit, Monitor());
      const double f = env("DOWN",0.95);
      VertexRemoval(this->Mesh, cost).Run(part(round+1<rounds ? env("MID",1.1) : f), Monitor());
    }
    flips.Run(Monitor());
    this->Fit(cost.Power.Power==4?FitTarget::LargestError:FitTarget::MeanError, env("REACH",1)*cost.Power.Unit, Monitor());
    if(v) printf("  removed to %zu of %zu\n", this->Mesh.NumberOfVertices(), number);
    MeshRefiner refiner(this->Mesh, number, &flips, cost.Power);
    refiner.InsertWhereFar(0.0, Monitor());
    refiner.InsertAtSides(0.0, Monitor());
  }

  HeightMesh& Mesh;
  const DecimationOptions& Options;
};
}

//----------------------------------------------------------------------------------------------------------------------
Decimation Decimate(const BoundedHorizon& horizon, const DecimationOptions& options, const Monitor& monitor)
{
  CheckAtLeast("maximum error", options.MaximumError, 0.0, " lattice units");
  const std::vector<PlanePoint> columns = ToColumns(horizon);
  HeightMesh mesh(horizon, columns, monitor.Step(0.0, 0.1));
  if (options.MaximumNumberOfPoints > 0 && options.MaximumNumberOfPoints < mesh.NumberOfVertices())
  {
    throw InputError("maximum number of points " + std::to_string(options.MaximumNumberOfPoints) +
      ", expected at least the " + std::to_string(mesh.NumberOfVertices()) + " of the loops, which are kept");
  }
  Decimator(mesh, options).Run(monitor.Step(0.1, 0.9));
  return MakeResult(mesh, monitor.Step(0.9, 1.0));
}
}
