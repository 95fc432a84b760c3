// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StreamProgress.h"

#include <algorithm>

namespace SeismicHorizons
{
namespace
{
const DecodingBuffer* DecoderOf(const std::istream& stream)
{
  return dynamic_cast<const DecodingBuffer*>(stream.rdbuf());
}
}

//----------------------------------------------------------------------------------------------------------------------
double CountBytes(std::istream& stream)
{
  const bool canTell = stream.good() && !DecoderOf(stream);
  const std::istream::pos_type here = canTell ? stream.tellg() : std::istream::pos_type(-1);
  if (here == std::istream::pos_type(-1))
  {
    return 0.0;
  }
  stream.seekg(0, std::ios::end);
  const std::istream::pos_type end = stream.tellg();
  stream.seekg(here);
  return static_cast<double>(end - here);
}

//----------------------------------------------------------------------------------------------------------------------
double PartRead(const std::istream& stream, double bytesRead, double bytesInStream)
{
  if (const DecodingBuffer* const decoder = DecoderOf(stream))
  {
    return decoder->PartRead();
  }
  return bytesInStream > 0.0 ? std::min(1.0, bytesRead / bytesInStream) : 0.0;
}
}
