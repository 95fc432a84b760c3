// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Horizons in parts, joined: one mesh that is as good as that of the whole.

#include "Common/Base/Parallel.h"
#include "Generator/HorizonGenerator.h"
#include "SurfaceParts.h"
#include "Tools/Check.h"
#include "Tools/Patches.h"
#include "Tools/TestHorizons.h"

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
SurfaceParts::Points ToPoints(const Patches::Columns& columns, const std::vector<double>& heights)
{
  return { columns, heights };
}

std::vector<std::int32_t> RandomCuts(const Patches::Columns& columns, int most, Patches::Random& random)
{
  std::int32_t greatest = 0;
  for (const PlanePoint& column : columns)
  {
    greatest = std::max(greatest, column.Y);
  }
  std::vector<std::int32_t> cuts;
  for (int n = 0; n < most; ++n)
  {
    cuts.push_back(random.Below(greatest + 3) - 1);
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

SurfaceOptions RandomOptions(int seed, Patches::Random& random)
{
  SurfaceOptions options;
  options.MaximumError = 0.4 * random.Below(6);
  options.Radius = 1 + (seed / 10) % 4;
  options.Effort = seed % 3 == 0 ? DecimationEffort::Best : DecimationEffort::Fast;
  if (seed % 4 == 0)
  {
    options.SmallestHoleSize = 1 + random.Below(20);
  }
  return options;
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
    const SurfaceParts::Points points = ToPoints(columns, TestHorizons::MakeHeights(columns, random));
    const SurfaceOptions options = RandomOptions(seed, random);
    const std::vector<std::int32_t> cuts = RandomCuts(columns, 1 + random.Below(6), random);
    SurfaceParts::Columns onOutlines;
    const std::vector<SurfacePart> parts = SurfaceParts::MakeParts(points, cuts, options, onOutlines);
    const std::string wrong = SurfaceParts::Check(points, parts, JoinSurface(parts), onOutlines, options.MaximumError);
    if (!CHECK_EQUAL(wrong, std::string()))
    {
      std::cerr << "seed " << seed << ", radius " << *options.Radius << ", error " << options.MaximumError << '\n';
    }
  }
}

/// The voxels of a generated horizon: holes, one of them with an island, a ragged outline, single missing voxels.
SurfaceParts::Points MakeGenerated(std::uint64_t seed, double dropouts)
{
  HorizonGeneratorOptions options;
  options.Seed = seed;
  options.Size = { 170, 140, 60 };
  options.NumberOfHorizons = 1;
  options.DropoutFraction = dropouts;
  const LatticeHorizon voxels = HorizonGenerator(options).MakeHorizon(0);
  Patches::Columns columns;
  std::vector<double> heights;
  for (std::size_t n = 0; n < voxels.Column.size(); ++n)
  {
    columns.push_back({ voxels.Column[n].X, voxels.Column[n].Y });
    heights.push_back(double(voxels.K[n]));
  }
  return ToPoints(columns, heights);
}

double AreaOf(const std::vector<PlanePoint>& vertices, const Loops& boundary)
{
  double area = 0.0;
  boundary.ForEachEdge([&](PointId from, PointId to)
    { area -= 0.5 * double(ExactPlane::Cross(vertices[std::size_t(from)], vertices[std::size_t(to)])); });
  return area;
}

/// As many holes and patches as in one piece, the same area but for what outlines may move, not many more vertices.
void TestGenerated()
{
  for (int seed = 1; seed <= 12; ++seed)
  {
    const SurfaceParts::Points points = MakeGenerated(std::uint64_t(seed), seed % 2 == 0 ? 0.03 : 0.0);
    SurfaceOptions options;
    options.MaximumError = seed % 3 == 0 ? 1.5 : 0.75;
    options.Radius = seed % 4 == 3 ? 2 : 1;
    SurfaceParts::Columns onOutlines;
    std::vector<std::int32_t> cuts;
    for (int part = 1; part < 2 + seed % 6; ++part)
    {
      cuts.push_back(140 * part / (2 + seed % 6));
    }
    const std::vector<SurfacePart> parts = SurfaceParts::MakeParts(points, cuts, options, onOutlines);
    const JoinedSurface joined = JoinSurface(parts);
    CHECK_EQUAL(SurfaceParts::Check(points, parts, joined, onOutlines, options.MaximumError), std::string());
    const std::vector<SurfacePart> whole = SurfaceParts::MakeParts(points, {}, options, onOutlines);
    CHECK_EQUAL(joined.NumberOfPatches, JoinSurface(whole).NumberOfPatches);
    CHECK_EQUAL(joined.Boundary.Size(), whole[0].Boundary.Size());
    const double area = AreaOf(whole[0].Vertices, whole[0].Boundary);
    CHECK(std::abs(AreaOf(joined.Vertices, joined.Boundary) - area) < 0.008 * area);
    CHECK(joined.SeamVertices > 0 && double(joined.Vertices.size()) < 1.25 * double(whole[0].Vertices.size()));
  }
}

/// One part without seams is the mesh that it was.
void TestOnePart()
{
  for (int seed = 1; seed <= 40; ++seed)
  {
    Patches::Random random(std::uint64_t(seed) * 31u);
    const Patches::Columns columns = Patches::Make(Patches::Shape(seed % int(Patches::Shape::Count)), random);
    const SurfaceParts::Points points = ToPoints(columns, TestHorizons::MakeHeights(columns, random));
    SurfaceParts::Columns onOutlines;
    const std::vector<SurfacePart> parts = SurfaceParts::MakeParts(points, {}, RandomOptions(seed, random), onOutlines);
    const JoinedSurface joined = JoinSurface(parts);
    CHECK(joined.Triangles == parts[0].Triangles && joined.Vertices == parts[0].Vertices);
    CHECK(joined.Count == parts[0].Count);
    CHECK_EQUAL(joined.Boundary.Size(), parts[0].Boundary.Size());
    CHECK_EQUAL(joined.Boundary.TotalLength(), parts[0].Boundary.TotalLength());
  }
}

SurfaceParts::Points FromPicture(const std::vector<std::string>& rows)
{
  const Patches::Columns columns = Patches::FromPicture(rows);
  return ToPoints(columns, std::vector<double>(columns.size(), 4.0));
}

JoinedSurface JoinPicture(const std::vector<std::string>& rows, const std::vector<std::int32_t>& cuts, int radius = 1,
  std::int64_t minimumPatchSize = 1)
{
  SurfaceOptions options;
  options.MaximumError = 0.0;
  options.Radius = radius;
  const SurfaceParts::Points points = FromPicture(rows);
  SurfaceParts::Columns onOutlines;
  const std::vector<SurfacePart> parts = SurfaceParts::MakeParts(points, cuts, options, onOutlines);
  JoinedSurface joined = JoinSurface(parts, minimumPatchSize);
  if (minimumPatchSize == 1)
  {
    CHECK_EQUAL(SurfaceParts::Check(points, parts, joined, onOutlines, 0.0), std::string());
  }
  return joined;
}

void TestPictures()
{
  // Of a rectangle nothing is left of the seams but their ends.
  const std::vector<std::string> rectangle(7, "########");
  const JoinedSurface flat = JoinPicture(rectangle, { 2, 4 });
  CHECK_EQUAL(flat.Vertices.size(), 8u);
  CHECK_EQUAL(flat.Triangles.size(), 18u);
  CHECK_EQUAL(flat.Boundary.TotalLength(), 8u);
  CHECK_EQUAL(flat.SeamVertices, 0u);
  // Parts of two rows each.
  CHECK_EQUAL(JoinPicture(rectangle, { 1, 2, 3, 4, 5 }).Vertices.size(), 14u);
  // Seams below, at the least row, at the greatest, and above.
  CHECK_EQUAL(JoinPicture(rectangle, { -3, 0, 6, 9 }).Triangles.size(), 6u);
  // A single point on the seam, and a row that is nothing but a seam.
  CHECK_EQUAL(JoinPicture({ "###", ".#.", "###" }, { 1 }).NumberOfPatches, 1u);
  CHECK_EQUAL(JoinPicture({ "...", ".#.", "..." }, { 1 }).Boundary.TotalLength(), 1u);
  CHECK_EQUAL(JoinPicture({ "....", "####", "...." }, { 1 }).Boundary.TotalLength(), 2u);
  // An empty row of a seam parts what the radius does, too.
  CHECK_EQUAL(JoinPicture({ "###", "...", "###" }, { 1 }).NumberOfPatches, 2u);
  CHECK_EQUAL(JoinPicture({ "###", "...", "...", "###" }, { 2 }).NumberOfPatches, 2u);
}

void TestHoles()
{
  const auto withHole = [](int width, int height)
  {
    std::vector<std::string> rows(11, std::string(14, '#'));
    for (int row = 0; row < height; ++row)
    {
      rows[std::size_t(5 - height / 2 + row)].replace(
        6 - std::size_t(width) / 2, std::size_t(width), std::size_t(width), '.');
    }
    return rows;
  };
  // Cut through the middle: large ones stay open, small ones are closed, single gaps too.
  CHECK_EQUAL(JoinPicture(withHole(5, 5), { 5 }).Boundary.Size(), 2u);
  CHECK_EQUAL(JoinPicture(withHole(3, 5), { 5 }).Boundary.Size(), 2u);
  CHECK_EQUAL(JoinPicture(withHole(2, 3), { 5 }).Boundary.Size(), 1u);
  CHECK_EQUAL(JoinPicture(withHole(2, 3), { 4 }).Boundary.Size(), 1u);
  CHECK_EQUAL(JoinPicture(withHole(1, 1), { 5 }).Boundary.Size(), 1u);
  CHECK_EQUAL(JoinPicture(withHole(1, 1), { 5 }).SeamVertices, 0u);
  // Cut by several seams, and only touched.
  CHECK_EQUAL(JoinPicture(withHole(6, 7), { 3, 5, 6 }).Boundary.Size(), 2u);
  CHECK_EQUAL(JoinPicture(withHole(6, 7), { 1, 9 }).Boundary.Size(), 2u);
  CHECK_EQUAL(JoinPicture(withHole(6, 7), { 2, 8 }).Boundary.Size(), 2u);
  // An island in a hole, on the seam and off it, is a patch of its own.
  std::vector<std::string> island = withHole(9, 9);
  island[5][6] = '#';
  for (const std::int32_t cut : { 3, 4, 5, 6 })
  {
    CHECK_EQUAL(JoinPicture(island, { cut }).NumberOfPatches, 2u);
    CHECK_EQUAL(JoinPicture(island, { cut }).Boundary.Size(), 3u);
  }
  // A gap that is narrow on the seam and opens into holes on both sides is open.
  std::vector<std::string> waist = withHole(8, 9);
  waist[5] = "#####..#######";
  CHECK_EQUAL(JoinPicture(waist, { 5 }).Boundary.Size(), 2u);
  CHECK_EQUAL(JoinPicture(waist, { 4 }).Boundary.Size(), 2u);
}

/// Points that a seam drops count for the nearer one beside them that it keeps.
void TestDroppedOnSeams()
{
  SurfaceParts::Points points;
  for (const PlanePoint& column :
    Patches::FromPicture({ "...########################", "...########################" }))
  {
    points.Columns.push_back(column);
    points.Height.push_back(std::abs(column.X - 11.0)); // a fold, where the seam keeps a point
  }
  BoundaryOptions options;
  options.KeepHoles = true;
  options.Seams.Lower = 0;
  const ExteriorBoundary boundary = FindExteriorBoundary(points.Columns, options);
  const SeamChains seams = SimplifySeams(points.Columns, points.Height, boundary.Boundary, options, 0.25);
  CHECK_EQUAL(seams.Kept.size(), 3u);
  CHECK_EQUAL(seams.Dropped.size(), 21u);
  const auto distance = [&](const DroppedPoint& one, PointId kept)
  { return std::abs(points.Columns[std::size_t(one.Point)].X - points.Columns[std::size_t(kept)].X); };
  for (const DroppedPoint& one : seams.Dropped)
  {
    for (const PointId kept : seams.Kept)
    {
      CHECK(distance(one, one.Target) <= distance(one, kept));
    }
  }
}

/// Patches are counted after they were joined.
void TestSmallPatches()
{
  const std::vector<std::string> rows = { "##....####", "##....####", "..........", ".##...####", "......####" };
  CHECK_EQUAL(JoinPicture(rows, { 2 }, 1).NumberOfPatches, 4u);
  CHECK_EQUAL(JoinPicture(rows, { 2 }, 1, 3).NumberOfPatches, 3u);
  CHECK_EQUAL(JoinPicture(rows, { 3 }, 1, 3).NumberOfPatches, 3u);
  CHECK_EQUAL(JoinPicture(rows, { 3 }, 1, 5).NumberOfPatches, 2u);
  CHECK_EQUAL(JoinPicture(rows, { 3 }, 1, 5).DroppedPoints, 6);
  CHECK_EQUAL(JoinPicture(rows, { 3 }, 1, 9).NumberOfPatches, 0u);
  CHECK_EQUAL(JoinPicture(rows, { 3 }, 1, 9).Vertices.size(), 0u);
  // With a radius of 2, patches of both sides are one. Between seams so near to each other a bay is as a hole.
  CHECK_EQUAL(JoinPicture(rows, { 2 }, 2).NumberOfPatches, 4u);
  CHECK_EQUAL(JoinPicture(rows, { 3 }, 2).NumberOfPatches, 2u);
  CHECK_EQUAL(JoinPicture(rows, { 1, 3 }, 2).NumberOfPatches, 1u);
}

void TestThreads()
{
  const SurfaceParts::Points points = MakeGenerated(5, 0.03);
  SurfaceOptions options;
  const auto tell = [&]()
  {
    SurfaceParts::Columns onOutlines;
    const std::vector<SurfacePart> parts = SurfaceParts::MakeParts(points, { 30, 71, 72, 110 }, options, onOutlines);
    return SurfaceParts::Tell(parts, JoinSurface(parts));
  };
  Detail::NumberOfThreads() = 1;
  const std::string onOne = tell();
  Detail::NumberOfThreads() = 3;
  CHECK(tell() == onOne);
  Detail::NumberOfThreads() = 0;
}

void TestSeamErrors()
{
  const SurfaceParts::Points points = FromPicture(std::vector<std::string>(7, "########"));
  const auto refuse = [&](const std::string& message, void (*change)(SurfaceOptions&))
  {
    SurfaceOptions options;
    options.KeepHoles = true;
    options.Seams.Lower = 0;
    change(options);
    CHECK_THROWS_WITH(MakeSurface(points, options), message);
  };
  refuse("a seam without hole boundaries, expected", [](SurfaceOptions& o) { o.KeepHoles = false; });
  refuse("a seam and a minimum patch size of 3 points, expected 1", [](SurfaceOptions& o) { o.MinimumPatchSize = 3; });
  refuse("a seam and growth by distance with a radius of 2 columns, expected clockwise growth",
    [](SurfaceOptions& o)
    {
      o.Radius = 2;
      o.Growth = GrowthStrategy::Distance;
    });
  refuse(
    "a seam and a number of triangles, expected an error", [](SurfaceOptions& o) { o.MaximumNumberOfTriangles = 9; });
  refuse("seams at row 0 and at row 0, expected the lower one at a smaller row",
    [](SurfaceOptions& o) { o.Seams.Upper = 0; });
  refuse("point 0 in row 0, expected none beyond the seams (lower: 2, upper: none)",
    [](SurfaceOptions& o) { o.Seams.Lower = 2; });
  refuse("in row 6, expected none beyond the seams (lower: 0, upper: 5)", [](SurfaceOptions& o) { o.Seams.Upper = 5; });
}

void TestJoinErrors()
{
  const SurfaceParts::Points points = MakeGenerated(5, 0.03);
  SurfaceParts::Columns onOutlines;
  const auto make = [&](const std::vector<std::int32_t>& cuts, double error)
  {
    SurfaceOptions options;
    options.MaximumError = error;
    return SurfaceParts::MakeParts(points, cuts, options, onOutlines);
  };
  std::vector<SurfacePart> parts = make({ 60, 90 }, 0.75);
  const auto refuse = [&](const std::string& message, const std::vector<std::size_t>& chosen)
  {
    std::vector<SurfacePart> some;
    for (const std::size_t part : chosen)
    {
      some.push_back(parts[part]);
    }
    CHECK_THROWS_WITH(JoinSurface(some), message);
  };
  refuse("part 0 with its lower seam at row 60, expected none below the first part", { 1, 2 });
  refuse("part 1 with its lower seam at row 90, expected that above the part before, row 60", { 0, 2 });
  refuse("part 1 with its lower seam at none, expected", { 0, 0 });
  refuse("the last part with its upper seam at row 90, expected a part beyond it", { 0, 1 });
  // Of other parameters, or another horizon.
  const std::vector<SurfacePart> coarse = make({ 60, 90 }, 3.0);
  CHECK_THROWS_WITH(JoinSurface({ parts[0], coarse[1], parts[2] }), "on both sides of a seam, expected the same");
  for (double& height : parts[1].Height)
  {
    height += 1.0;
  }
  refuse("on both sides of a seam, expected the same: parts of one horizon", { 0, 1, 2 });
  SurfaceOptions options;
  options.Radius = 1;
  SurfacePart none = SurfaceParts::ToPart(points, Surface(), parts[2].Seams);
  parts = make({ 60, 90 }, 0.75);
  CHECK_THROWS_WITH(JoinSurface({ parts[0], parts[1], none }), "no edge of part 2 at column (");
}
}

int TestSurfaceJoin(int, char*[])
{
  TestRandomPatches();
  TestGenerated();
  TestOnePart();
  TestPictures();
  TestHoles();
  TestDroppedOnSeams();
  TestSmallPatches();
  TestThreads();
  TestSeamErrors();
  TestJoinErrors();
  return Check::Result();
}
