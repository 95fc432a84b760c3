// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridFormat_h
#define SeismicHorizonsGridFormat_h

#include <cstddef>
#include <optional>
#include <string_view>

namespace SeismicHorizons
{
/// Documentation/HorizonGridFormats.md describes each format.
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

const char* FormatName(GridFormat format);

constexpr std::size_t RecognitionBytes = 16 * 1024;

/// Recognises content, as formats share file extensions. Points without column and row are no EarthVision grid.
std::optional<GridFormat> RecogniseGrid(std::string_view firstBytes);
}

#endif
