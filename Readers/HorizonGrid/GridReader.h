// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads a horizon from the grid file of another program, whichever of the formats it is in.

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
/// How many bytes of a text file are held at a time. A longer line makes the buffer grow.
constexpr std::size_t GridBufferSize = 4 * 1024 * 1024;

/// The format of a file by the bytes from where the stream is, which goes back there; nothing when it is none of those
/// known. Throws InputError when reading fails.
std::optional<GridFormat> RecogniseGrid(std::istream& stream);

/// Recognises the format by the content (GridFormat.h) and reads the whole file, from where the stream is, which must
/// be able to go back there. The lattice comes with all rotation, shear and handedness that the format has; unit,
/// domain, coordinate system and name where the file states them. Values stay in the unit and with the sign of the
/// file.
///
/// Throws InputError when the file is of no known format, or breaks it; the text says where, as "line 17: ..." or
/// "byte 100: ...", what was found, and what was expected. Progress is by bytes.
HorizonGrid ReadHorizonGrid(
  std::istream& stream, const Monitor& monitor = Monitor(), std::size_t bufferSize = GridBufferSize);
}

#endif
