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
/// Each thread needs its own object.
class SEGYFile
{
public:
  SEGYFile(const std::string& name, const SEGYHeader& header);

  void ReadTraceHeader(std::int64_t trace, unsigned char* bytes);

  void ReadTraces(std::int64_t first, std::int64_t count, unsigned char* bytes);

private:
  void Read(std::int64_t trace, std::int64_t size, unsigned char* bytes);

  std::ifstream Stream;
  const std::int64_t FirstTrace;
  const std::int64_t TraceSize;
};
}

#endif
