// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYFile.h"

#include "Common/Text/FileErrors.h"

#include <filesystem>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
SEGYFile::SEGYFile(const std::string& name, const SEGYHeader& header)
  : FirstTrace(header.FirstTrace)
  , TraceSize(std::int64_t(header.TraceSize()))
{
  this->Stream.rdbuf()->pubsetbuf(nullptr, 0); // With a buffer each header would be read with kilobytes of samples.
  this->Stream.open(std::filesystem::u8path(name), std::ios::binary);
  if (!this->Stream)
  {
    throw FileError(FileProblem::CannotOpen, "the file cannot be opened, expected a readable one");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::Read(std::int64_t trace, std::int64_t size, unsigned char* bytes)
{
  this->Stream.seekg(this->FirstTrace + trace * this->TraceSize);
  if (!this->Stream.read(reinterpret_cast<char*>(bytes), size))
  {
    throw InputError("trace " + std::to_string(trace + 1) + " cannot be read, expected an unchanged file");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::ReadTraceHeader(std::int64_t trace, unsigned char* bytes)
{
  this->Read(trace, SEGYTraceHeaderSize, bytes);
}

//----------------------------------------------------------------------------------------------------------------------
void SEGYFile::ReadTraces(std::int64_t first, std::int64_t count, unsigned char* bytes)
{
  this->Read(first, count * this->TraceSize, bytes);
}
}
