// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSEGYFile_h
#define SeismicHorizonsSEGYFile_h

#include "SEGYHeader.h"

#include <cstdint>
#include <fstream>
#include <string>

namespace SeismicHorizons
{
/// The traces of a file, as bytes. For one thread; each takes a file of its own. Throws InputError where reading fails.
class SEGYFile
{
public:
  SEGYFile(const std::string& name, const SEGYHeader& header);

  /// The 240 bytes of the header of a trace.
  void ReadTraceHeader(std::int64_t trace, unsigned char* bytes);

  /// Whole traces one after the other, with their headers.
  void ReadTraces(std::int64_t first, std::int64_t count, unsigned char* bytes);

private:
  void Read(std::int64_t trace, std::int64_t size, unsigned char* bytes);

  std::ifstream Stream;
  const std::int64_t FirstTrace;
  const std::int64_t TraceSize;
};
}

#endif
