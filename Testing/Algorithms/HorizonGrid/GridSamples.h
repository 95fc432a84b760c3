// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// One small grid as each format has it: 3 x 2 nodes from (1000, 5000) by steps of 50 and 25, with the values 1 2 3 in
// the southern row and 4, none, 6 in the northern one. In text files the last value is one digit, so that no cut of a
// file can go unnoticed.

#ifndef SeismicHorizonsGridSamples_h
#define SeismicHorizonsGridSamples_h

#include "Readers/HorizonGrid/GridReader.h"
#include "Tools/Check.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace GridSamples
{
using SeismicHorizons::HorizonGrid;

constexpr double None = std::numeric_limits<double>::quiet_NaN();

// ---- Bytes -------------------------------------------------------------------------------------------------------
template <typename Number>
std::string LittleEndian(Number number)
{
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t,
    std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint16_t>>;
  Bits bits = 0;
  std::memcpy(&bits, &number, sizeof(Number));
  std::string bytes;
  for (std::size_t n = 0; n < sizeof(Number); ++n)
  {
    bytes += static_cast<char>((bits >> (8 * n)) & 0xFF);
  }
  return bytes;
}

template <typename Number>
std::string BigEndian(Number number)
{
  const std::string bytes = LittleEndian(number);
  return std::string(bytes.rbegin(), bytes.rend());
}

template <typename Number>
std::string LittleEndian(const std::vector<Number>& numbers)
{
  std::string bytes;
  for (const Number number : numbers)
  {
    bytes += LittleEndian(number);
  }
  return bytes;
}

template <typename Number>
std::string BigEndian(const std::vector<Number>& numbers)
{
  std::string bytes;
  for (const Number number : numbers)
  {
    bytes += BigEndian(number);
  }
  return bytes;
}

/// A Fortran record.
inline std::string Record(const std::string& payload)
{
  const std::string length = BigEndian(static_cast<std::int32_t>(payload.size()));
  return length + payload + length;
}

// ---- The grid in each format -------------------------------------------------------------------------------------
inline std::string IrapText()
{
  return "-996 2 50.0 25.0\n1000.0 1100.0 5000.0 5025.0\n3 0.0 1000.0 5000.0\n0 0 0 0 0 0 0\n"
         " 1 2 3 4 9999900.0000\n 6\n";
}

/// The header of an IRAP file of 3 x 2 nodes with steps, and a rotation around a centre.
inline std::string IrapBinaryHeader(float dx, float dy, float degrees, float centreX = 1000, float centreY = 5000)
{
  return Record(BigEndian<std::int32_t>({ -996, 2 }) + BigEndian<float>({ 1000, 1100, 5000, 5025, dx, dy })) +
    Record(BigEndian<std::int32_t>(3) + BigEndian<float>({ degrees, centreX, centreY })) +
    Record(std::string(28, '\0'));
}

inline std::string IrapBinary()
{
  return IrapBinaryHeader(50, 25, 0) + Record(BigEndian<float>({ 1, 2, 3 })) +
    Record(BigEndian<float>({ 4, 1e30f, 6 }));
}

inline std::string Storm()
{
  return "STORMGRID_BINARY\n\n3 2 50.0 25.0\n1000.0 1100.0 5000.0 5025.0\n" +
    BigEndian<double>({ 1, 2, 3, 4, -999, 6 });
}

inline std::string Zmap()
{
  return "! comment\n@top HEADER , GRID, 5\n10, -99999.0, , 0, 1\n2, 3, 1000.0, 1100.0, 5000.0, 5025.0\n"
         "0.0, 0.0, 0.0\n@\n         4         1\n  -99999.0         2\n         6         3\n";
}

inline std::string Cps3()
{
  return "FSASCI 0 1 COMPUTED 0 1.0E+30\nFSATTR 0 0\nFSLIMI 1000.0 1100.0 5000.0 5025.0 1.0 6.0\nFSNROW 2 3\n"
         "FSXINC 50.0 25.0\n->top\n4 1 0.1E+31 2 6\n3\n";
}

inline std::string EarthVision()
{
  return "# Type: scattered data\n# Version: 7\n# Field: 1 x\n# Field: 2 y\n# Field: 3 z meters\n"
         "# Field: 4 column integer\n# Field: 5 row integer\n# Projection: Local Rectangular\n# Units: meters\n# End:\n"
         "# Grid_size: 3 x 2\n1000 5000 1 1 1\n1050 5000 2 2 1\n1100 5000 3 3 1\n1000 5025 4 1 2\n"
         "1100 5025 6 3 2\n";
}

inline std::string SurferText()
{
  return "DSAA\n3 2\n1000.0 1100.0\n5000.0 5025.0\n1.0 6.0\n1 2 3\n\n4 1.70141e+38 6\n";
}

inline std::string SurferBinary()
{
  return "DSBB" + LittleEndian<std::int16_t>({ 3, 2 }) + LittleEndian<double>({ 1000, 1100, 5000, 5025, 1, 6 }) +
    LittleEndian<float>({ 1, 2, 3, 4, 1.70141e38f, 6 });
}

/// Parts of a Surfer 7 file.
inline std::string Section(const std::string& name, const std::string& content)
{
  return name + LittleEndian(static_cast<std::int32_t>(content.size())) + content;
}

inline std::string Surfer7(int version = 2, double rotation = 0.0)
{
  return Section("DSRB", LittleEndian<std::int32_t>(version)) + Section("NOTE", "other") +
    Section("GRID",
      LittleEndian<std::int32_t>({ 2, 3 }) + LittleEndian<double>({ 1000, 5000, 50, 25, 1, 6, rotation, 5.5 })) +
    Section("DATA", LittleEndian<double>({ 1, 2, 3, 4, 5.5, 6 }));
}

/// The lines of a GXF file around its values.
inline std::string GxfHeader(const std::string& more = {})
{
  return "some text before\n! comment\n#TITLE\n\"the top\"\n#POINTS\n3\n#ROWS\n2\n#PTSEPARATION\n50.0\n#RWSEPARATION\n"
         "25.0\n#XORIGIN\n1000.0\n#YORIGIN\n5000.0\n#DUMMY\n-1e32\n" +
    more;
}

inline std::string Gxf()
{
  return GxfHeader() + "#GRID\n1 2 3\n4 -1.0D+32 6\n";
}

/// Two digits a value: "%&" is 1. The last two values are one without value, and 6.
inline std::string CompressedGxf()
{
  return GxfHeader("#GTYPE\n2\n") + "#GRID\n%&%'%(\n%)!!%+\n";
}

inline std::string EsriGrid()
{
  return "ncols 3\nnrows 2\nxllcenter 1000.0\nyllcenter 5000.0\ndx 50.0\ndy 25.0\nNODATA_value -9999\n4 -9999 6\n"
         "1 2 3\n";
}

inline std::vector<std::string> All()
{
  return { IrapText(), IrapBinary(), Storm(), Zmap(), Cps3(), EarthVision(), SurferText(), SurferBinary(), Surfer7(),
    Gxf(), CompressedGxf(), EsriGrid() };
}

// ---- Reading and checking ----------------------------------------------------------------------------------------
inline HorizonGrid Read(const std::string& file, std::size_t bufferSize = SeismicHorizons::GridBufferSize)
{
  std::istringstream stream(file);
  return SeismicHorizons::ReadHorizonGrid(stream, SeismicHorizons::Monitor(), bufferSize);
}

/// With none equal to none.
inline bool IsSame(const std::vector<double>& a, const std::vector<double>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

inline bool IsNear(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return (a - b).norm() <= 1e-9 * (1.0 + a.norm());
}

inline bool HasLattice(const HorizonGrid& grid, const Eigen::Vector2d& origin, const Eigen::Vector2d& columnStep,
  const Eigen::Vector2d& rowStep)
{
  return IsNear(grid.Lattice.Origin, origin) && IsNear(grid.Lattice.ColumnStep, columnStep) &&
    IsNear(grid.Lattice.RowStep, rowStep) &&
    grid.Z.size() == std::size_t(grid.Lattice.Columns[0]) * std::size_t(grid.Lattice.Columns[1]);
}

inline bool HasValues(const HorizonGrid& grid, const std::vector<double>& values)
{
  return IsSame(grid.Z, values);
}

inline bool IsTheSample(const HorizonGrid& grid)
{
  return grid.Lattice.Columns[0] == 3 && HasLattice(grid, { 1000, 5000 }, { 50, 0 }, { 0, 25 }) &&
    HasValues(grid, { 1, 2, 3, 4, None, 6 });
}

/// A file with a part replaced; the part has to be there.
inline std::string Replace(std::string file, const std::string& part, const std::string& by)
{
  const std::size_t place = file.find(part);
  CHECK(place != std::string::npos);
  return file.replace(place, part.size(), by);
}
}

#endif
