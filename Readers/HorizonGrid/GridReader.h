// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grids keep rotation, shear and handedness of the file, and values its unit and sign. Unit, domain, coordinate system
// and name are set if the file states them.

#ifndef SeismicHorizonsGridReader_h
#define SeismicHorizonsGridReader_h

#include "Common/Base/Monitor.h"
#include "Common/Survey/HorizonGrid.h"
#include "Common/Survey/NullValues.h"

#include <cstddef>
#include <istream>

namespace SeismicHorizons
{
/// A longer line enlarges the buffer.
constexpr std::size_t GridBufferSize = 4 * 1024 * 1024;

/// Recognises content, as formats share file extensions. Leaves the stream where it was.
bool IsGrid(std::istream& stream);

/// Reads a format of Documentation/HorizonGrid.md from a seekable stream. Throws InputError if the format is unknown or violated, with the position
/// ("line 17: ..." or "byte 100: ..."), the text found and the text expected. Words among `nulls` are no value.
HorizonGrid ReadHorizonGrid(std::istream& stream, const Monitor& monitor = Monitor(),
  std::size_t bufferSize = GridBufferSize, const NullValues& nulls = NullValues());
}

#endif
