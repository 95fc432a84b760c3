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
constexpr std::size_t RoomInFront = 4096; // bytes
constexpr std::size_t LeastAhead = 1 << 16; // bytes
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
  , PieceSize(std::max(size, SmallestSize) - 1)
{
  this->Now.IsLast = stream.eof();
}

//----------------------------------------------------------------------------------------------------------------------
bool LineBuffer::Read()
{
  do
  {
    if (!this->Ahead.valid())
    {
      this->ReadAhead();
    }
    this->Ahead.get();
    this->TakeNext();
  } while (this->Complete == 0 && this->Now.IsRead);
  return this->Now.IsRead;
}

//----------------------------------------------------------------------------------------------------------------------
// Starting a thread takes longer than reading a small piece.
void LineBuffer::ReadAhead()
{
  const auto policy = this->PieceSize < LeastAhead
    ? std::launch::deferred
    : std::launch::async | std::launch::deferred; // where no thread can start
  this->Ahead = std::async(policy, [this]() { this->ReadNext(); });
}

//----------------------------------------------------------------------------------------------------------------------
void LineBuffer::ReadNext()
{
  Piece& next = this->Next;
  next.First = std::min(this->PieceSize, RoomInFront);
  next.Bytes.resize(next.First + this->PieceSize + 1);
  this->Stream.read(next.Bytes.data() + next.First, std::streamsize(this->PieceSize));
  next.Size = std::size_t(this->Stream.gcount());
  next.IsLast = this->Stream.eof();
  next.IsRead = this->Stream.good() || next.IsLast;
  this->BytesRead += next.Size;
  next.Part = SeismicHorizons::PartRead(this->Stream, double(this->BytesRead), this->BytesInStream);
}

//----------------------------------------------------------------------------------------------------------------------
void LineBuffer::TakeNext()
{
  const std::size_t rest = this->Now.Size - this->Complete;
  if (rest >= LongestLine && double(rest) > this->BytesInStream)
  {
    const std::size_t before = this->BytesRead - this->Next.Size - rest;
    throw InputError("byte " + std::to_string(this->Start + std::int64_t(before)) + ": a line of more than " +
      std::to_string(LongestLine) + " bytes, expected a shorter one");
  }
  rest <= this->Next.First ? this->MoveInFront(rest) : this->Append(rest);
  char* const first = this->Now.Bytes.data() + this->Now.First;
  if (this->Now.IsLast)
  {
    first[this->Now.Size++] = '\n';
  }
  const auto end = std::make_reverse_iterator(first + this->Now.Size);
  const auto start = std::make_reverse_iterator(first + rest);
  const auto newline = std::find(end, start, '\n');
  this->Complete = newline == start ? 0 : std::size_t(newline.base() - first);
  if (this->Now.IsRead && !this->Now.IsLast)
  {
    this->ReadAhead();
  }
}

//----------------------------------------------------------------------------------------------------------------------
void LineBuffer::MoveInFront(std::size_t rest)
{
  Piece& next = this->Next;
  next.First -= rest;
  next.Size += rest;
  std::copy_n(this->Last(), rest, next.Bytes.data() + next.First);
  std::swap(this->Now, next);
}

//----------------------------------------------------------------------------------------------------------------------
// The buffer of a long line doubles, so that the line is not copied with each piece.
void LineBuffer::Append(std::size_t rest)
{
  Piece& now = this->Now;
  if (this->Last() != now.Bytes.data())
  {
    std::copy(this->Last(), this->Last() + rest, now.Bytes.data());
  }
  const std::size_t size = rest + this->Next.Size;
  if (now.Bytes.size() <= size)
  {
    now.Bytes.resize(2 * size);
  }
  std::copy_n(this->Next.Bytes.data() + this->Next.First, this->Next.Size, now.Bytes.data() + rest);
  now.First = 0;
  now.Size = size;
  now.IsRead = this->Next.IsRead;
  now.IsLast = this->Next.IsLast;
  now.Part = this->Next.Part;
}
}
