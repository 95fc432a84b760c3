// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// libsegyio is told that samples are single bytes, so that it reads them as they are. It knows neither all formats nor
// line numbers at any byte, and would swap the bytes of little-endian files by its own list of fields.

#include "SEGYFile.h"

#include "Common/FileErrors.h"

#include <segyio/segy.h>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::Close::operator()(segy_file_handle* file) const
{
  segy_close(file);
}

//----------------------------------------------------------------------------------------------------------------------
SEGYFile::SEGYFile(const std::string& name, const SEGYHeader& header)
  : File(segy_open(name.c_str(), "rb"))
  , FirstTrace(header.FirstTrace)
  , DataSize(int(header.DataSize()))
{
  if (!this->File)
  {
    throw FileError(FileProblem::CannotOpen, "a file that can not be opened, expected a readable one");
  }
  segy_set_format(this->File.get(), SEGY_SIGNED_CHAR_1_BYTE);
}

//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::Check(int error, std::int64_t trace) const
{
  if (error != SEGY_OK)
  {
    throw InputError("trace " + std::to_string(trace + 1) + " that can not be read (error " + std::to_string(error) +
      " of libsegyio), expected the file to stay as it was");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::ReadTraceHeader(std::int64_t trace, unsigned char* bytes)
{
  char* const buffer = reinterpret_cast<char*>(bytes);
  this->Check(segy_traceheader(this->File.get(), int(trace), buffer, this->FirstTrace, this->DataSize), trace);
}

//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::ReadTraces(std::int64_t first, std::int64_t count, unsigned char* bytes)
{
  // To libsegyio it is a single long trace, whose header ends where the first of the traces begins.
  const std::int64_t size = SEGYTraceHeaderSize + std::int64_t(this->DataSize);
  const std::int64_t begin = this->FirstTrace + first * size - SEGYTraceHeaderSize;
  this->Check(segy_readtrace(this->File.get(), 0, bytes, begin, int(count * size)), first);
}
}
