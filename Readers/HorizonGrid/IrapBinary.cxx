// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridParsers.h"
#include "IrapHeader.h"

namespace SeismicHorizons
{
namespace
{
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

IrapHeader ReadBinaryHeader(GridBytes& bytes)
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
  return header;
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
HorizonGrid ReadIrapBinary(GridBytes& bytes)
{
  HorizonGrid grid;
  const IrapHeader header = ReadBinaryHeader(bytes);
  grid.Lattice = PrefixErrors(bytes.Place(), [&] { return IrapLattice(header); });
  grid.Z = ReadRecords(bytes, CountNodes(header.Columns));
  return grid;
}
}
