// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Errors.h"
#include "Common/Text/TextNumbers.h"
#include "GridBytes.h"
#include "GridParsers.h"
#include "GridText.h"
#include "HeaderFields.h"

#include <cmath>

namespace SeismicHorizons
{
namespace
{
/// The largest coordinates of the header are ignored, since they hold before the rotation.
struct IrapHeader
{
  std::array<int, 2> Columns = {};
  std::array<double, 2> Steps = {};
  Eigen::Vector2d Origin = Eigen::Vector2d::Zero();
  double Degrees = 0.0; // counterclockwise
  Eigen::Vector2d Centre = Eigen::Vector2d::Zero(); // of the rotation
};

std::string PointText(const Eigen::Vector2d& place)
{
  return '(' + ShortestText(place.x()) + ", " + ShortestText(place.y()) + ')';
}

/// Throws InputError if the rotation is not around the origin, because programs disagree on its meaning.
SurveyLattice IrapLattice(const IrapHeader& header)
{
  const double step = std::min(std::fabs(header.Steps[0]), std::fabs(header.Steps[1]));
  if (header.Degrees != 0.0 && (header.Centre - header.Origin).cwiseAbs().maxCoeff() > LargestNodeShift * step)
  {
    throw InputError(
      "a rotation around " + PointText(header.Centre) + ", expected the origin, " + PointText(header.Origin));
  }
  return TurnedLattice(header.Columns, header.Origin, header.Steps, header.Degrees);
}

// ---- Text -----------------------------------------------------------------------------------------------------------
constexpr double FirstNull = 9999900.0;
constexpr int UnusedNumbers = 7;

SurveyLattice ReadIrapHeader(GridText& text)
{
  IrapHeader header;
  text.Word("-996");
  header.Columns[1] = text.Count("ny");
  header.Steps[0] = text.Number("dx");
  header.Steps[1] = text.Number("dy");
  header.Origin.x() = text.Number("xmin");
  text.Number("xmax");
  header.Origin.y() = text.Number("ymin");
  text.Number("ymax");
  header.Columns[0] = text.Count("nx");
  header.Degrees = text.Number("rotation");
  header.Centre.x() = text.Number("x of the rotation");
  header.Centre.y() = text.Number("y of the rotation");
  for (int n = 0; n < UnusedNumbers; ++n)
  {
    text.Number("a line of seven zeros");
  }
  return PrefixErrors(text.Place(), [&] { return IrapLattice(header); });
}

// ---- Binary ---------------------------------------------------------------------------------------------------------
constexpr float LeastBinaryNull = 1e30f;
constexpr std::int32_t UnusedBytes = 28;

/// Fortran records have their length before and after them.
void ReadLength(GridBytes& bytes, std::int32_t expected)
{
  const std::string place = bytes.Place();
  const auto length = bytes.Read<std::int32_t>("the length of a record");
  if (length != expected)
  {
    throw InputError(
      place + ": a record of " + std::to_string(length) + " bytes, expected " + std::to_string(expected));
  }
}

SurveyLattice ReadIrapHeader(GridBytes& bytes)
{
  IrapHeader header;
  ReadLength(bytes, 32);
  bytes.Read<std::int32_t>("-996");
  header.Columns[1] = bytes.ReadCount<std::int32_t>("ny");
  header.Origin.x() = bytes.ReadFinite<float>("xmin");
  bytes.ReadFinite<float>("xmax");
  header.Origin.y() = bytes.ReadFinite<float>("ymin");
  bytes.ReadFinite<float>("ymax");
  header.Steps[0] = bytes.ReadFinite<float>("dx");
  header.Steps[1] = bytes.ReadFinite<float>("dy");
  ReadLength(bytes, 32);
  ReadLength(bytes, 16);
  header.Columns[0] = bytes.ReadCount<std::int32_t>("nx");
  header.Degrees = bytes.ReadFinite<float>("rotation");
  header.Centre.x() = bytes.ReadFinite<float>("x of the rotation");
  header.Centre.y() = bytes.ReadFinite<float>("y of the rotation");
  ReadLength(bytes, 16);
  ReadLength(bytes, UnusedBytes);
  bytes.Skip(UnusedBytes, "seven unused numbers");
  ReadLength(bytes, UnusedBytes);
  return PrefixErrors(bytes.Place(), [&] { return IrapLattice(header); });
}

/// Records are usually rows, but may have any length. Data after the last value is ignored: some programs write notes
/// there.
std::vector<double> ReadRecords(GridBytes& bytes, std::int64_t count)
{
  std::vector<double> values;
  values.reserve(bytes.Room(count, sizeof(float)));
  while (count > 0)
  {
    const std::string place = bytes.Place();
    const auto length = bytes.Read<std::int32_t>("a record of values");
    const std::int64_t valuesInRecord = length / std::int64_t(sizeof(float));
    if (length <= 0 || length % sizeof(float) != 0 || valuesInRecord > count)
    {
      throw InputError(place + ": a record of " + std::to_string(length) + " bytes, expected one of 1 to " +
        std::to_string(count) + " values of 4 bytes");
    }
    bytes.ReadValues<float>(valuesInRecord, NullFrom(LeastBinaryNull), values);
    ReadLength(bytes, length);
    count -= valuesInRecord;
  }
  return values;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadIrapText(GridText& text)
{
  HorizonGrid grid;
  grid.Lattice = ReadIrapHeader(text);
  grid.Z = text.Values(CountNodes(grid.Lattice.Columns), NullFrom(FirstNull));
  text.RequireEnd();
  return grid;
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadIrapBinary(GridBytes& bytes)
{
  HorizonGrid grid;
  grid.Lattice = ReadIrapHeader(bytes);
  grid.Z = ReadRecords(bytes, CountNodes(grid.Lattice.Columns));
  return grid;
}
}
