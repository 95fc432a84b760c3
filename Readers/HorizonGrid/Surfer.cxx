// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridBytes.h"
#include "GridParsers.h"
#include "GridText.h"

namespace SeismicHorizons
{
namespace
{
/// In Surfer 6 nodes from this value upwards have no z.
constexpr double SurferNull = 1.70141e38;

// ---- Surfer 7 -------------------------------------------------------------------------------------------------------
struct Section
{
  std::string Name;
  std::int32_t Size = 0;
  std::string Place;
};

Section ReadSection(GridBytes& bytes, const std::string& expected)
{
  Section section;
  section.Place = bytes.Place();
  section.Name.resize(4);
  bytes.Read(section.Name.data(), section.Name.size(), expected);
  section.Size = bytes.Read<std::int32_t>("the size of a section");
  if (section.Size < 0)
  {
    throw InputError(section.Place + ": a section of " + std::to_string(section.Size) + " bytes, expected at least 0");
  }
  return section;
}

/// Unknown sections are skipped.
Section FindSection(GridBytes& bytes, const std::string& name)
{
  Section section = ReadSection(bytes, "a section " + name);
  while (section.Name != name)
  {
    bytes.Skip(section.Size, "the rest of a section");
    section = ReadSection(bytes, "a section " + name);
  }
  return section;
}

void RequireSize(const Section& section, std::int64_t size)
{
  if (section.Size != size)
  {
    throw InputError(section.Place + ": a section " + section.Name + " of " + std::to_string(section.Size) +
      " bytes, expected " + std::to_string(size));
  }
}

std::int32_t ReadVersion(GridBytes& bytes)
{
  RequireSize(FindSection(bytes, "DSRB"), 4);
  const std::string place = bytes.Place();
  const auto version = bytes.Read<std::int32_t>("the version");
  if (version != 1 && version != 2)
  {
    throw InputError(place + ": version " + std::to_string(version) + ", expected 1 or 2");
  }
  return version;
}

struct SurferHeader
{
  SurveyLattice Lattice;
  double Null = 0.0;
};

SurferHeader ReadSurferHeader(GridBytes& bytes)
{
  SurferHeader header;
  RequireSize(FindSection(bytes, "GRID"), 72);
  const int ny = bytes.ReadCount<std::int32_t>("nRow");
  const int nx = bytes.ReadCount<std::int32_t>("nCol");
  const double x = bytes.ReadFinite<double>("xLL");
  const double y = bytes.ReadFinite<double>("yLL");
  const double dx = bytes.ReadFinite<double>("xSize");
  const double dy = bytes.ReadFinite<double>("ySize");
  header.Lattice = PrefixErrors(bytes.Place(), [&] { return TurnedLattice({ nx, ny }, { x, y }, { dx, dy }, 0.0); });
  bytes.Read<double>("zMin");
  bytes.Read<double>("zMax");
  const std::string place = bytes.Place();
  if (bytes.ReadFinite<double>("rotation") != 0.0)
  {
    throw InputError(place + ": a rotation, expected 0 as the format does not use it");
  }
  header.Null = bytes.Read<double>("the blank value");
  return header;
}
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadSurferText(GridText& text)
{
  HorizonGrid grid;
  text.Word("DSAA");
  const int nx = text.Count("nx");
  const int ny = text.Count("ny");
  const double xFirst = text.Number("xlo");
  const double xLast = text.Number("xhi");
  const double yFirst = text.Number("ylo");
  const double yLast = text.Number("yhi");
  grid.Lattice = PrefixErrors(text.Place(),
    [&] {
      return AxisLattice({ nx, ny }, { xFirst, xLast }, { yFirst, yLast });
    });
  text.Number("zlo");
  text.Number("zhi");
  grid.Z = text.Values(CountNodes(grid.Lattice.Columns), NullFrom(SurferNull));
  text.RequireEnd();
  return grid;
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadSurferBinary(GridBytes& bytes)
{
  HorizonGrid grid;
  bytes.Skip(4, "DSBB");
  const int nx = bytes.ReadCount<std::int16_t>("nx");
  const int ny = bytes.ReadCount<std::int16_t>("ny");
  const double xFirst = bytes.ReadFinite<double>("xlo");
  const double xLast = bytes.ReadFinite<double>("xhi");
  const double yFirst = bytes.ReadFinite<double>("ylo");
  const double yLast = bytes.ReadFinite<double>("yhi");
  grid.Lattice = PrefixErrors(bytes.Place(),
    [&] {
      return AxisLattice({ nx, ny }, { xFirst, xLast }, { yFirst, yLast });
    });
  bytes.Read<double>("zlo");
  bytes.Read<double>("zhi");
  grid.Z = bytes.Values<float>(CountNodes(grid.Lattice.Columns), NullFrom(static_cast<float>(SurferNull)));
  bytes.RequireEnd();
  return grid;
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadSurfer7(GridBytes& bytes)
{
  HorizonGrid grid;
  const std::int32_t version = ReadVersion(bytes);
  const SurferHeader header = ReadSurferHeader(bytes);
  grid.Lattice = header.Lattice;
  const std::int64_t count = CountNodes(grid.Lattice.Columns);
  const Section data = FindSection(bytes, "DATA");
  if (data.Size % sizeof(double) != 0 || data.Size / std::int64_t(sizeof(double)) != count)
  {
    throw InputError(data.Place + ": a section DATA of " + std::to_string(data.Size) + " bytes, expected " +
      std::to_string(count) + " values of 8 bytes");
  }
  grid.Z = bytes.Values<double>(count, version == 1 ? NullFrom(header.Null) : NullRule{ header.Null });
  return grid;
}
}
