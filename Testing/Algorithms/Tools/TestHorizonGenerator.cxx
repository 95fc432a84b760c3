// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The generator of synthetic horizons: it keeps what its options promise, and makes what it always made.

#include "Check.h"
#include "Generator/AnticlineSurvey.h"
#include "Generator/HorizonGenerator.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
using Columns = std::set<std::pair<int, int>>;

HorizonGeneratorOptions MakeOptions(std::uint64_t seed)
{
  HorizonGeneratorOptions options;
  options.Seed = seed;
  options.Size = { 120, 100, 60 };
  return options;
}

Columns ColumnsOf(const LatticeHorizon& horizon)
{
  Columns columns;
  for (std::size_t voxel = 0; voxel < horizon.Column.size(); ++voxel)
  {
    columns.insert({ horizon.Column[voxel].X, horizon.Column[voxel].Y });
  }
  return columns;
}

/// Takes one part of the columns away, the connected component of the first, and returns its size.
std::size_t TakePart(Columns& columns, bool overCorners)
{
  std::vector<std::pair<int, int>> front = { *columns.begin() };
  columns.erase(columns.begin());
  std::size_t size = 0;
  while (!front.empty())
  {
    const auto [i, j] = front.back();
    front.pop_back();
    ++size;
    for (int di = -1; di <= 1; ++di)
    {
      for (int dj = -1; dj <= 1; ++dj)
      {
        if ((overCorners || di == 0 || dj == 0) && columns.erase({ i + di, j + dj }) == 1)
        {
          front.push_back({ i + di, j + dj });
        }
      }
    }
  }
  return size;
}

std::vector<std::size_t> SizesOfParts(Columns columns, bool overCorners)
{
  std::vector<std::size_t> sizes;
  while (!columns.empty())
  {
    sizes.push_back(TakePart(columns, overCorners));
  }
  return sizes;
}

/// The columns that are not occupied, with a frame around the lattice so that all of the outside is connected.
Columns MissingColumns(const Columns& occupied, const SparseMatrixSize& size)
{
  Columns missing;
  for (int j = -1; j <= size[1]; ++j)
  {
    for (int i = -1; i <= size[0]; ++i)
    {
      if (occupied.count({ i, j }) == 0)
      {
        missing.insert({ i, j });
      }
    }
  }
  return missing;
}

// ---- The file ----------------------------------------------------------------------------------------------------
void FileHoldsTheSameAsTheArrays()
{
  const HorizonGenerator generator(MakeOptions(3));
  std::stringstream stream;
  const std::map<int, std::int64_t> counts = generator.Write(stream);
  const SparseMatrix matrix = ReadSparseMatrix(stream);
  CHECK((matrix.Size == generator.Options().Size));
  CHECK_EQUAL(matrix.Horizons.size(), 3u);
  for (int position = 0; position < 3; ++position)
  {
    const LatticeHorizon made = generator.MakeHorizon(position);
    const LatticeHorizon& read = matrix.Horizons.at(static_cast<std::size_t>(position));
    CHECK_EQUAL(read.SurfaceId, made.SurfaceId);
    CHECK_EQUAL(counts.at(made.SurfaceId), static_cast<std::int64_t>(made.Column.size()));
    CHECK(read.Column == made.Column && read.K == made.K);
    CHECK(read.Thickness == made.Thickness && read.Amplitude == made.Amplitude && read.RealZ == made.RealZ);
    CHECK_EQUAL(read.DroppedDuplicates, 0);
  }
}

std::string TextOf(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void DataAreReproduced(const std::string& dataFolder)
{
  std::ostringstream blobs;
  HorizonGenerator(MakeOptions(1)).Write(blobs);
  CHECK(TextOf(dataFolder + "/blobs.vsm") == blobs.str());
  std::ostringstream sample;
  WriteAnticlineSurvey(sample);
  CHECK(TextOf(dataFolder + "/sample.vsm") == sample.str());
}

void SeedChangesTheHorizons()
{
  const auto make = [](std::uint64_t seed) { return HorizonGenerator(MakeOptions(seed)).MakeHorizon(0); };
  CHECK(make(1).K == make(1).K);
  CHECK(make(1).K != make(2).K);
}

// ---- The shape ---------------------------------------------------------------------------------------------------
/// Each inside the lattice, and above the one before.
void CheckOrder(const HorizonGenerator& generator)
{
  std::map<std::pair<int, int>, int> above;
  for (int position = 0; position < generator.Options().NumberOfHorizons; ++position)
  {
    const LatticeHorizon horizon = generator.MakeHorizon(position);
    CHECK_EQUAL(ColumnsOf(horizon).size(), horizon.Column.size());
    for (std::size_t voxel = 0; voxel < horizon.Column.size(); ++voxel)
    {
      const int k = horizon.K[voxel];
      const auto [place, isFirst] = above.insert({ { horizon.Column[voxel].X, horizon.Column[voxel].Y }, k });
      CHECK(k >= 0 && k < generator.Options().Size[2] && (isFirst || k > place->second));
      place->second = k;
    }
  }
}

void HorizonsLieAboveEachOther()
{
  // As low as a cube may be for its horizons, and so with the least distance between them.
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    HorizonGeneratorOptions options = MakeOptions(seed);
    options.Size = { 120, 100, 20 };
    options.NumberOfHorizons = 4;
    CheckOrder(HorizonGenerator(options));
  }
  HorizonGeneratorOptions rough;
  rough.NoiseFraction = 1.0;
  rough.NoiseHeight = 3.7; // nearly the largest
  rough.NoiseGaps = 0.0;
  CheckOrder(HorizonGenerator(rough));
}

void IslandsAndHolesAreThere()
{
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
  {
    HorizonGeneratorOptions options = MakeOptions(seed);
    options.DropoutFraction = 0.0;
    const HorizonGenerator generator(options);
    for (int position = 0; position < options.NumberOfHorizons; ++position)
    {
      const Columns occupied = ColumnsOf(generator.MakeHorizon(position));
      CHECK(SizesOfParts(occupied, true).size() >= 1u + static_cast<std::size_t>(options.NumberOfIslands));
      const std::vector<std::size_t> gaps = SizesOfParts(MissingColumns(occupied, options.Size), false);
      CHECK(gaps.size() >= 1u + static_cast<std::size_t>(options.NumberOfHoles));
      CHECK(*std::max_element(gaps.begin() + 1, gaps.end()) > 200u); // the large hole
    }
  }
}

void OutlineIsConcave()
{
  const Columns occupied = ColumnsOf(HorizonGenerator(MakeOptions(1)).MakeHorizon(0));
  int rowsInParts = 0;
  for (int j = 0; j < 100; ++j)
  {
    int wideGaps = 0;
    int last = 120;
    for (int i = 0; i < 120; ++i)
    {
      if (occupied.count({ i, j }) == 1)
      {
        wideGaps += i - last > 8 ? 1 : 0;
        last = i;
      }
    }
    rowsInParts += wideGaps > 0 ? 1 : 0;
  }
  CHECK(rowsInParts > 20);
}

void DropoutsAreSingleAndAsMany()
{
  for (const double fraction : { 0.01, 0.02, 0.03, 0.1 })
  {
    HorizonGeneratorOptions options = MakeOptions(5);
    options.Size = { 300, 300, 60 };
    options.DropoutFraction = 0.0;
    const Columns complete = ColumnsOf(HorizonGenerator(options).MakeHorizon(0));
    options.DropoutFraction = fraction;
    const Columns thinned = ColumnsOf(HorizonGenerator(options).MakeHorizon(0));
    Columns dropped;
    std::set_difference(
      complete.begin(), complete.end(), thinned.begin(), thinned.end(), std::inserter(dropped, dropped.end()));
    const double found = static_cast<double>(dropped.size()) / static_cast<double>(complete.size());
    CHECK(std::abs(found - fraction) < 0.15 * fraction);
    CHECK_EQUAL(SizesOfParts(dropped, true).size(), dropped.size());
    CHECK_EQUAL(complete.size(), thinned.size() + dropped.size());
  }
}

/// From a star to a square ever more columns of the same lattice are filled.
void SquarenessFillsTheBox()
{
  std::size_t last = 0;
  for (const double squareness : { -1.0, -0.5, 0.0, 0.5, 1.0 })
  {
    HorizonGeneratorOptions options = MakeOptions(4);
    options.Size = { 200, 200, 60 };
    options.NumberOfHoles = 0;
    options.NumberOfIslands = 0;
    options.Squareness = squareness;
    const std::size_t size = ColumnsOf(HorizonGenerator(options).MakeHorizon(0)).size();
    CHECK(size > last + 500);
    last = size;
  }
}

void AttributesArePlausible()
{
  const LatticeHorizon horizon = HorizonGenerator(MakeOptions(1)).MakeHorizon(1);
  int negative = 0;
  for (std::size_t voxel = 0; voxel < horizon.Column.size(); ++voxel)
  {
    CHECK(horizon.Thickness[voxel] >= 1.0 && horizon.Thickness[voxel] <= 6.0);
    CHECK(std::abs(horizon.Amplitude[voxel]) >= 400.0 && std::abs(horizon.Amplitude[voxel]) <= 2100.0);
    CHECK(std::abs(horizon.RealZ[voxel] - 4.0 * horizon.K[voxel]) <= 2.0005);
    negative += horizon.Amplitude[voxel] < 0.0 ? 1 : 0;
  }
  const double part = negative / static_cast<double>(horizon.Column.size());
  CHECK(part > 0.005 && part < 0.3);
}

/// In the part of the area that was asked for heights are off by up to three cells, and half of the voxels are missing;
/// elsewhere nothing changes.
void NoiseIsInPatches()
{
  HorizonGeneratorOptions options;
  options.Size = { 400, 400, 120 };
  options.DropoutFraction = 0.0;
  std::map<std::pair<int, int>, int> heights;
  const LatticeHorizon smooth = HorizonGenerator(options).MakeHorizon(0);
  for (std::size_t voxel = 0; voxel < smooth.Column.size(); ++voxel)
  {
    heights[{ smooth.Column[voxel].X, smooth.Column[voxel].Y }] = smooth.K[voxel];
  }
  options.NoiseFraction = 0.3;
  const LatticeHorizon noisy = HorizonGenerator(options).MakeHorizon(0);
  const double size = static_cast<double>(smooth.Column.size());
  CHECK(std::abs((size - static_cast<double>(noisy.Column.size())) / size - 0.5 * 0.3) < 0.02);
  int off = 0;
  int largest = 0;
  for (std::size_t voxel = 0; voxel < noisy.Column.size(); ++voxel)
  {
    const int difference = std::abs(noisy.K[voxel] - heights.at({ noisy.Column[voxel].X, noisy.Column[voxel].Y }));
    off += difference > 0 ? 1 : 0;
    largest = std::max(largest, difference);
  }
  CHECK_EQUAL(largest, 3);
  CHECK(std::abs(off / size - 0.5 * 0.3 * 5.0 / 6.0) < 0.02); // of offsets of up to 3, a sixth is below a half
  options.NoiseGaps = 0.0;
  CHECK_EQUAL(HorizonGenerator(options).MakeHorizon(0).Column.size(), smooth.Column.size());
}

// ---- The options -------------------------------------------------------------------------------------------------
void FeaturesCanBeTurnedOff()
{
  HorizonGeneratorOptions options;
  options.Size = { 1, 1, 5 };
  options.NumberOfHorizons = 1;
  options.NumberOfHoles = 0;
  options.NumberOfIslands = 0;
  CHECK(HorizonGenerator(options).MakeHorizon(0).Column.size() <= 1u);
}

void SizeFollowsTheNumberOfPoints()
{
  HorizonGeneratorOptions options;
  for (const std::int64_t wanted : { 50000, 400000 })
  {
    options.Size = { 240, 200, 120 };
    options.Size = HorizonGenerator::FindSize(options, wanted);
    CHECK(std::abs(options.Size[0] / 1.2 - options.Size[1]) < 1.0);
    CHECK_EQUAL(options.Size[2], 120);
    std::size_t found = 0;
    for (int position = 0; position < options.NumberOfHorizons; ++position)
    {
      found += HorizonGenerator(options).MakeHorizon(position).Column.size();
    }
    CHECK(std::abs(static_cast<double>(found) / static_cast<double>(wanted) - 1.0) < 0.03);
  }
}

template <typename Change>
void CheckRefused(Change change, const std::string& message)
{
  HorizonGeneratorOptions options;
  change(options);
  CHECK_THROWS_WITH(HorizonGenerator(options), message);
}

void OptionsAreChecked()
{
  using Options = HorizonGeneratorOptions;
  CheckRefused([](Options& o) { o.Size[1] = 0; }, "size 240 x 0 x 120, expected three positive integers");
  CheckRefused([](Options& o) { o.Size = { 2147483647, 2147483647, 100 }; }, "expected a product below 2^63");
  CheckRefused([](Options& o) { o.NumberOfHorizons = 0; }, "0 horizons, expected at least 1");
  CheckRefused([](Options& o) { o.Size[2] = 14; },
    "size 240 x 200 x 14 for 3 horizons, expected nZ at least five times the number of horizons");
  CheckRefused([](Options& o) { o.NumberOfHoles = -1; }, "-1 holes, expected 0 or more");
  CheckRefused([](Options& o) { o.NumberOfIslands = -1; }, "-1 islands, expected 0 or more");
  CheckRefused(
    [](Options& o) { o.NumberOfHoles = 5000; }, "5000 holes, expected no more than the lattice has room for");
  CheckRefused(
    [](Options& o) { o.NumberOfIslands = 5000; }, "5000 islands, expected no more than the lattice has room for");
  for (const double part : { -0.01, 0.11, std::numeric_limits<double>::quiet_NaN() })
  {
    CheckRefused([part](Options& o) { o.DropoutFraction = part; }, "expected a part from 0 to 0.1");
  }
  CheckRefused([](Options& o) { o.Squareness = 1.5; }, "squareness 1.500000, expected a number from -1 to 1");
  CheckRefused([](Options& o) { o.NoiseFraction = -0.1; }, "noise -0.100000, expected a part of the area from 0 to 1");
  CheckRefused([](Options& o) { o.NoiseGaps = 1.0; }, "noise gaps 1.000000, expected a part of the voxels from 0 to");
  const auto high = [](Options& o)
  {
    o.NoiseFraction = 0.5;
    o.NoiseHeight = 4.0;
  };
  CheckRefused(high, "noise height 4.000000, expected 0 to 3.712500, for which there is room between the horizons");
  CHECK_THROWS_WITH(HorizonGenerator::FindSize(Options(), 0), "0 points, expected at least 1");
}

void WritingStopsOnErrorsAndOnRequest()
{
  const HorizonGenerator generator(MakeOptions(1));
  std::ostream broken(nullptr);
  CHECK_THROWS_WITH(generator.Write(broken), "writing failed");
  std::ostringstream stream;
  CHECK_THROWS_WITH(generator.Write(stream, Monitor([](double part) { return part < 0.5; })), "stopped on request");
}
}

int TestHorizonGenerator(int argc, char* argv[])
{
  FileHoldsTheSameAsTheArrays();
  if (CHECK(argc > 1))
  {
    DataAreReproduced(argv[1]);
  }
  SeedChangesTheHorizons();
  HorizonsLieAboveEachOther();
  IslandsAndHolesAreThere();
  OutlineIsConcave();
  DropoutsAreSingleAndAsMany();
  SquarenessFillsTheBox();
  NoiseIsInPatches();
  AttributesArePlausible();
  FeaturesCanBeTurnedOff();
  SizeFollowsTheNumberOfPoints();
  OptionsAreChecked();
  WritingStopsOnErrorsAndOnRequest();
  return Check::Result();
}
