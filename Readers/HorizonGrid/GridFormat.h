// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridFormat_h
#define SeismicHorizonsGridFormat_h

#include <cstddef>
#include <optional>
#include <string_view>

namespace SeismicHorizons
{
/// The files of gridding programs that can be read. Documentation/HorizonGridFormats.md describes each.
enum class GridFormat
{
  IrapText,
  IrapBinary,
  Storm,
  Zmap,
  Cps3,
  EarthVision,
  SurferText,
  SurferBinary,
  Surfer7,
  Gxf,
  EsriGrid
};

/// For people: "IRAP classic ASCII grid".
const char* FormatName(GridFormat format);

/// How many bytes at the start of a file are enough to recognise its format.
constexpr std::size_t RecognitionBytes = 16 * 1024;

/// The format of a file by the bytes it begins with, never by its name: several programs share one ending. Nothing when
/// it is none of these. Points with column and row are an EarthVision grid; without, they are not one.
std::optional<GridFormat> RecogniseGrid(std::string_view firstBytes);
}

#endif
