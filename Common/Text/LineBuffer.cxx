// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineBuffer.h"

#include "Common/Base/Errors.h"
#include "StreamProgress.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t SmallestSize = 2; // One character and a newline.
constexpr std::size_t LongestLine = (1 << 26) - 1; // Bytes, for streams of unknown length.
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string_view> CutLines(std::string_view lines, std::size_t size)
{
  std::vector<std::string_view> blocks;
  while (!lines.empty())
  {
    const std::size_t end = size < lines.size() ? lines.find('\n', size) + 1 : lines.size();
    blocks.push_back(lines.substr(0, end));
    lines.remove_prefix(end);
  }
  return blocks;
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t CountLines(std::string_view text)
{
  // Counts fit a byte, so that compilers vectorise the loop.
  constexpr std::size_t most = std::numeric_limits<unsigned char>::max();
  std::int64_t lines = 0;
  while (!text.empty())
  {
    const std::string_view some = text.substr(0, most);
    unsigned char count = 0;
    for (const char letter : some)
    {
      count = static_cast<unsigned char>(count + (letter == '\n'));
    }
    lines += count;
    text.remove_prefix(some.size());
  }
  return lines;
}

//----------------------------------------------------------------------------------------------------------------------
LineBuffer::LineBuffer(std::istream& stream, std::size_t size)
  : Stream(stream)
  , Start(std::max<std::int64_t>(0, stream.tellg()))
  , BytesInStream(CountBytes(stream))
  , Bytes(std::max(size, SmallestSize))
{
}

//----------------------------------------------------------------------------------------------------------------------
double LineBuffer::PartRead() const
{
  return SeismicHorizons::PartRead(this->Stream, static_cast<double>(this->BytesRead), this->BytesInStream);
}

//----------------------------------------------------------------------------------------------------------------------
bool LineBuffer::Read()
{
  std::copy(this->Last(), this->First() + this->Filled, this->Bytes.data());
  this->Filled -= this->Complete;
  this->Complete = 0;
  while (this->Complete == 0)
  {
    if (!this->ReadMore())
    {
      return false;
    }
  }
  return true;
}

//----------------------------------------------------------------------------------------------------------------------
bool LineBuffer::ReadMore()
{
  if (this->Filled + 1 == this->Bytes.size())
  {
    if (this->Filled >= LongestLine && static_cast<double>(this->Filled) > this->BytesInStream)
    {
      throw InputError("byte " + std::to_string(this->Start + std::int64_t(this->BytesRead - this->Filled)) +
        ": a line of more than " + std::to_string(this->Filled) + " bytes, expected a shorter one");
    }
    this->Bytes.resize(2 * this->Bytes.size());
  }
  this->Stream.read(
    this->Bytes.data() + this->Filled, static_cast<std::streamsize>(this->Bytes.size() - this->Filled - 1));
  const auto count = static_cast<std::size_t>(this->Stream.gcount());
  const auto fresh = std::make_reverse_iterator(this->Bytes.begin() + static_cast<std::ptrdiff_t>(this->Filled));
  this->Filled += count;
  this->BytesRead += count;
  if (this->Stream.eof())
  {
    this->Bytes[this->Filled++] = '\n';
  }
  const auto last = std::make_reverse_iterator(this->Bytes.begin() + static_cast<std::ptrdiff_t>(this->Filled));
  const auto newline = std::find(last, fresh, '\n');
  this->Complete = newline == fresh ? 0 : static_cast<std::size_t>(newline.base() - this->Bytes.begin());
  return this->Stream.good() || this->Stream.eof();
}
}
