// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGridReader_h
#define SeismicHorizonsGridReader_h

#include "Common/Monitor.h"
#include "Common/Survey/HorizonGrid.h"
#include "GridFormat.h"

#include <cstddef>
#include <istream>
#include <optional>

namespace SeismicHorizons
{
/// A longer line enlarges the buffer.
constexpr std::size_t GridBufferSize = 4 * 1024 * 1024;

/// Leaves the stream where it was.
std::optional<GridFormat> RecogniseGrid(std::istream& stream);

/// Recognises the format by content (GridFormat.h) and reads the file. The stream must be seekable. The lattice keeps
/// rotation, shear and handedness of the file; values keep its unit and sign. Unit, domain, coordinate system and name
/// are set if the file states them.
///
/// Throws InputError if the format is unknown or violated. Its text gives the position ("line 17: ..." or "byte 100:
/// ..."), what was found and what was expected.
HorizonGrid ReadHorizonGrid(
  std::istream& stream, const Monitor& monitor = Monitor(), std::size_t bufferSize = GridBufferSize);
}

#endif
