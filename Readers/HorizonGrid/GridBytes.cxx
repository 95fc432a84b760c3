// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GridBytes.h"

#include "Common/Text/StreamProgress.h"

#include <algorithm>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
GridBytes::GridBytes(std::istream& stream, const Monitor& monitor, ByteOrder order)
  : Stream(stream)
  , Work(monitor)
  , Order(order)
  , BytesInStream(CountBytes(stream))
{
}

//----------------------------------------------------------------------------------------------------------------------
void GridBytes::Read(char* bytes, std::size_t count, const std::string& name)
{
  this->Stream.read(bytes, static_cast<std::streamsize>(count));
  this->Position += this->Stream.gcount();
  if (this->Stream.bad())
  {
    throw this->Error("reading failed, expected " + name);
  }
  if (static_cast<std::size_t>(this->Stream.gcount()) != count)
  {
    throw FileError(FileProblem::CutOff, this->Place() + ": end of file, expected " + name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void GridBytes::Skip(std::int64_t count, const std::string& name)
{
  for (; count > 0; count -= std::min(count, MostBytesAtOnce))
  {
    this->Part.resize(MostBytesAtOnce);
    this->Read(this->Part.data(), static_cast<std::size_t>(std::min(count, MostBytesAtOnce)), name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t GridBytes::Room(std::int64_t count, std::size_t size) const
{
  return static_cast<std::size_t>(
    std::min(static_cast<double>(count), this->BytesInStream / static_cast<double>(size)));
}

//----------------------------------------------------------------------------------------------------------------------
void GridBytes::RequireEnd()
{
  if (this->Stream.peek() != std::istream::traits_type::eof())
  {
    throw this->Error("more bytes after the last value, expected the end of the file");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void GridBytes::ReadRest()
{
  this->Part.resize(MostBytesAtOnce);
  while (this->Stream.read(this->Part.data(), MostBytesAtOnce))
  {
    this->Work.Progress(1.0);
  }
}

//----------------------------------------------------------------------------------------------------------------------
const char* GridBytes::ReadPart(std::size_t count)
{
  this->Part.resize(count);
  this->Read(this->Part.data(), count, "values");
  this->Work.Progress(PartRead(this->Stream, static_cast<double>(this->Position), this->BytesInStream));
  return this->Part.data();
}
}
