// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons that are meshed in parts: one mesh within the error everywhere, as good as one that is made at once.

#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Predicates.h"
#include "Filters/Algorithms/Surface/RowSurface.h"
#include "PartInputs.h"
#include "SurfaceFit.h"
#include "SurfaceInputs.h"
#include "Tools/BoundaryChecker.h"
#include "Tools/Check.h"
#include "Tools/CrackedPatches.h"
#include "Tools/Patches.h"
#include "Tools/RealHorizons.h"
#include "Tools/TestHorizons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;
using namespace SurfaceInputs;
using namespace PartInputs;

namespace
{
/// What is wrong with a mesh; empty when nothing is.
std::string Check(const Points& points, const Surface& surface, double error, bool areEdgesBound = true)
{
  constexpr double rounding = 1e-9;
  const Decimation& mesh = surface.Mesh;
  BoundedHorizon horizon;
  horizon.Plane = mesh.Points.Plane;
  horizon.Height = mesh.Points.Height;
  horizon.Boundary = mesh.Points.Boundary;
  for (const PointId source : mesh.Points.Source)
  {
    horizon.Patch.push_back(surface.Boundary.Patch[std::size_t(source)]);
  }
  std::string wrong = MeshChecker::CheckMesh(horizon, mesh.Triangles, MeshChecker::Kind::Any);
  wrong = wrong.empty() ? BoundaryChecker::CheckCrossings(horizon) : wrong;
  const SurfaceFit::Fit fit = SurfaceFit::Measure(points, surface).Run();
  std::ostringstream text;
  const auto targets = std::count(mesh.Points.Target.begin(), mesh.Points.Target.end(), NoPoint);
  const bool areEdgesFar = fit.LargestOfEdges > error + rounding || mesh.LargestEdgeError > error + rounding ||
    fit.LargestOfEdges > mesh.LargestEdgeError + rounding;
  if (fit.Largest > error + rounding || mesh.LargestError > error + rounding || (areEdgesBound && areEdgesFar))
  {
    text << "errors " << fit.Largest << ' ' << mesh.LargestError << ' ' << fit.LargestOfEdges << ' '
         << mesh.LargestEdgeError;
  }
  else if (targets != 0 || mesh.Points.Target.size() != surface.Kept.size())
  {
    text << targets << " of " << mesh.Points.Target.size() << " points without a vertex";
  }
  return wrong.empty() ? text.str() : wrong;
}

/// Points that are read row by row.
class Reader : public RowReader
{
public:
  explicit Reader(const Points& points)
    : Given(points)
  {
  }

  PlaneBox Box() const override { return PlaneBox(this->Given.Columns); }
  void Read(
    std::int32_t first, std::int32_t last, std::vector<PlanePoint>& columns, std::vector<double>& height) const override
  {
    for (std::size_t n = 0; n < this->Given.Columns.size(); ++n)
    {
      if (this->Given.Columns[n].Y >= first && this->Given.Columns[n].Y <= last)
      {
        columns.push_back(this->Given.Columns[n]);
        height.push_back(this->Given.Height[n]);
      }
    }
  }

private:
  const Points& Given;
};

/// What differs between the points in memory and read row by row; empty when nothing does.
std::string CompareRows(const Points& points, const SurfaceOptions& options, Surface surface)
{
  std::vector<PointId> targets(points.Columns.size(), NoPoint);
  const auto numberOf = [&](PointId point) { return surface.Kept[std::size_t(point)]; };
  for (std::size_t n = 0; n < surface.Kept.size(); ++n)
  {
    targets[std::size_t(surface.Kept[n])] = surface.Mesh.Points.Target[n];
  }
  surface.Boundary.Boundary = surface.Boundary.Boundary.RenumberedBy(numberOf);
  std::transform(
    surface.Mesh.Points.Source.begin(), surface.Mesh.Points.Source.end(), surface.Mesh.Points.Source.begin(), numberOf);
  std::vector<PointId> read;
  const RowSurface byRows = MakeSurface(Reader(points), options, std::int64_t(points.Columns.size()),
    [&](PointId first, const std::vector<PointId>& some)
    {
      CHECK_EQUAL(std::size_t(first), read.size());
      read.insert(read.end(), some.begin(), some.end());
    });
  for (std::size_t n = 0; n < surface.Kept.size(); ++n)
  {
    CHECK_EQUAL(byRows.Patches.PatchAt(surface.Kept[n]), surface.Boundary.Patch[n]);
  }
  const std::string other = Tell(byRows.Made, read, byRows.DroppedPoints);
  const std::string own = Tell(surface, targets, std::int64_t(targets.size() - surface.Kept.size()));
  return own == other ? std::string() : "another surface from rows";
}

/// More with the variable SEEDS of the environment.
void TestRandomPatches()
{
  const char* const text = std::getenv("SEEDS");
  const int seeds = text ? std::atoi(text) : 600;
  for (int seed = 1; seed <= seeds; ++seed)
  {
    Patches::Random random(std::uint64_t(seed) * 7919u);
    const Patches::Columns columns = Patches::Make(Patches::Shape(seed % int(Patches::Shape::Count)), random);
    const Points points = SortedByRow(columns, TestHorizons::MakeHeights(columns, random));
    SurfaceOptions options = RandomOptions(random);
    options.KeepHoles = seed % 5 != 0;
    if (seed % 4 == 0)
    {
      options.SmallestHoleSize = 1 + random.Below(20);
    }
    if (seed % 7 == 0)
    {
      options.MinimumPatchSize = 1 + random.Below(9);
    }
    std::string wrong;
    try
    {
      const Surface surface = MakeSurface(points, options);
      wrong = Check(points, surface, options.MaximumError);
      wrong = wrong.empty() ? CompareRows(points, options, surface) : wrong;
    }
    catch (const std::exception& error)
    {
      wrong = error.what();
    }
    if (!CHECK_EQUAL(wrong, std::string()))
    {
      std::cerr << "seed " << seed << ", rows " << options.RowsOfPart << ", error " << options.MaximumError << '\n';
    }
  }
}

/// Edges that cross cut links have no error.
void TestCracks()
{
  for (int seed = 1; seed <= CrackedPatches::NumberOfLattices(); ++seed)
  {
    Patches::Random random(std::uint64_t(seed) * 104729u);
    const CrackedPatches::CrackedPatch patch = CrackedPatches::Make(random);
    const Points points = SortedByRow(patch.Columns, TestHorizons::MakeHeights(patch.Columns, random));
    SurfaceOptions options = RandomOptions(random);
    options.Cuts = &patch.Cuts;
    std::string wrong;
    try
    {
      const Surface surface = MakeSurface(points, options);
      wrong = Check(points, surface, options.MaximumError, false);
      CHECK(surface.Mesh.LargestEdgeError <= options.MaximumError + 1e-9);
    }
    catch (const std::exception& error)
    {
      wrong = error.what();
    }
    if (!CHECK_EQUAL(wrong, std::string()))
    {
      std::cerr << "cracked lattice " << seed << ", rows " << options.RowsOfPart << '\n';
    }
  }
}

/// As many holes and patches as in one piece, not many more vertices.
void TestGenerated()
{
  double more = 0.0;
  for (int seed = 1; seed <= 12; ++seed)
  {
    const Points points = MakeGenerated(std::uint64_t(seed), seed % 2 == 0 ? 0.03 : 0.0);
    SurfaceOptions options = Within(seed % 3 == 0 ? 1.5 : 0.75);
    options.Radius = 1;
    const Surface whole = MakeSurface(points, options);
    options.RowsOfPart = 120;
    const Surface surface = MakeSurface(points, options);
    CHECK_EQUAL(Check(points, surface, options.MaximumError), std::string());
    CHECK_EQUAL(surface.Mesh.Points.Boundary.Size(), whole.Mesh.Points.Boundary.Size());
    CHECK_EQUAL(surface.NumberOutside > 0, whole.NumberOutside > 0);
    more += double(surface.Mesh.Points.Source.size()) / double(whole.Mesh.Points.Source.size()) / 12.0;
    std::cerr << surface.Mesh.Points.Source.size() << " for " << whole.Mesh.Points.Source.size() << '\n';
  }
  CHECK(more < 1.05);
}

/// Whole heights of a smooth surface leave little of the error: where vertices are off, insertion would not end.
void TestSmooth()
{
  Points points;
  for (int n = 0; n < 900 * 600; ++n)
  {
    const PlanePoint column{ n % 900, n / 900 };
    points.Columns.push_back(column);
    points.Height.push_back(std::round(30.0 * std::sin(0.002 * column.X) * std::cos(0.0015 * column.Y)));
  }
  SurfaceOptions options = Within(0.75);
  options.Radius = 1;
  const Surface whole = MakeSurface(points, options);
  options.RowsOfPart = 200;
  const Surface surface = MakeSurface(points, options);
  std::cerr << surface.Mesh.Points.Source.size() << " for " << whole.Mesh.Points.Source.size() << '\n';
  CHECK(double(surface.Mesh.Points.Source.size()) < 1.2 * double(whole.Mesh.Points.Source.size()));
  CHECK(surface.Mesh.LargestLoopError <= 0.75 + 1e-9);
}

/// Bands of real horizons, where there are some, take as many vertices.
void TestReal()
{
  for (const std::filesystem::path& file : RealHorizons::Files())
  {
    std::vector<double> heights;
    const Patches::Columns columns = RealHorizons::Read(file, &heights);
    const Points points = SortedByRow(columns, heights);
    SurfaceOptions options = Within(0.75);
    options.Radius = 1;
    const Surface whole = MakeSurface(points, options);
    const PlaneBox box(points.Columns);
    options.RowsOfPart = std::max(64, (box.Greatest.Y - box.Least.Y) / 4);
    const Surface surface = MakeSurface(points, options);
    CHECK_EQUAL(points.Columns.size() < 100000 ? Check(points, surface, options.MaximumError) : "", std::string());
    CHECK(double(surface.Mesh.Points.Source.size()) < 1.02 * double(whole.Mesh.Points.Source.size()));
  }
}
}

int TestSurfaceParts(int, char*[])
{
  TestRandomPatches();
  TestCracks();
  TestGenerated();
  TestSmooth();
  TestReal();
  return Check::Result();
}
