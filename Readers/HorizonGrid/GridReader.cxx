// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridReader.h"

#include "Common/Text/LineErrors.h"
#include "GridParsers.h"

#include <string>

namespace SeismicHorizons
{
namespace
{
/// The first bytes; the stream is where it was.
std::string PeekBytes(std::istream& stream)
{
  const std::istream::pos_type start = stream.tellg();
  std::string bytes(RecognitionBytes, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  stream.clear(stream.rdstate() & std::ios::badbit);
  stream.seekg(start);
  if (!stream)
  {
    throw InputError("reading failed, expected a grid");
  }
  return bytes;
}

GridFormat RequireFormat(const std::string& firstBytes)
{
  if (firstBytes.empty())
  {
    throw InputError("empty file, expected a grid");
  }
  if (const std::optional<GridFormat> format = RecogniseGrid(firstBytes))
  {
    return *format;
  }
  throw InputError("a file that begins with " + Quote(firstBytes.substr(0, firstBytes.find('\n'))) +
    ", expected a grid of IRAP, STORM, ZMAP+, CPS-3, EarthVision, Surfer, GXF or Esri");
}

HorizonGrid ReadFormat(GridFormat format, std::istream& stream, const Monitor& monitor, std::size_t bufferSize)
{
  const auto text = [&](auto read)
  {
    GridText lines(stream, monitor, bufferSize);
    return read(lines);
  };
  const auto binary = [&](ByteOrder order, auto read)
  {
    GridBytes bytes(stream, monitor, order);
    HorizonGrid grid = read(bytes);
    bytes.ReadRest();
    return grid;
  };
  switch (format)
  {
    case GridFormat::IrapText:
      return text(ReadIrapText);
    case GridFormat::IrapBinary:
      return binary(ByteOrder::BigEndian, ReadIrapBinary);
    case GridFormat::Storm:
      return binary(ByteOrder::BigEndian, ReadStorm);
    case GridFormat::Zmap:
      return text(ReadZmap);
    case GridFormat::Cps3:
      return text(ReadCps3);
    case GridFormat::EarthVision:
      return text(ReadEarthVision);
    case GridFormat::SurferText:
      return text(ReadSurferText);
    case GridFormat::SurferBinary:
      return binary(ByteOrder::LittleEndian, ReadSurferBinary);
    case GridFormat::Surfer7:
      return binary(ByteOrder::LittleEndian, ReadSurfer7);
    case GridFormat::Gxf:
      return text(ReadGxf);
    case GridFormat::EsriGrid:
      return text(ReadEsriGrid);
  }
  return {};
}
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<GridFormat> RecogniseGrid(std::istream& stream)
{
  return RecogniseGrid(PeekBytes(stream));
}

//----------------------------------------------------------------------------------------------------------------------
HorizonGrid ReadHorizonGrid(std::istream& stream, const Monitor& monitor, std::size_t bufferSize)
{
  const GridFormat format = RequireFormat(PeekBytes(stream));
  HorizonGrid grid = ReadFormat(format, stream, monitor, bufferSize);
  grid.Format = FormatName(format);
  return grid;
}
}
