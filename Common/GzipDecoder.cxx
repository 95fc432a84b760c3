// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GzipDecoder.h"

#include "Errors.h"
#include "StreamProgress.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t InputSize = 64 * 1024;
constexpr int GzipOnly = 16; // added to the bits of the window
constexpr std::array<char, 2> Magic = { '\x1F', '\x8B' };
}

/// The state of zlib, which must not move.
struct GzipDecoder::Inflation
{
  z_stream Stream = {};
};

//----------------------------------------------------------------------------------------------------------------------
bool BeginsAsGzip(std::istream& stream)
{
  const std::istream::pos_type start = stream.tellg();
  std::array<char, 2> bytes = {};
  stream.read(bytes.data(), bytes.size());
  stream.clear(stream.rdstate() & std::ios::badbit);
  stream.seekg(start);
  return bytes == Magic;
}

//----------------------------------------------------------------------------------------------------------------------
GzipDecoder::GzipDecoder(std::unique_ptr<std::istream> compressed)
  : Compressed(std::move(compressed))
  , CompressedSize(CountBytes(*this->Compressed))
  , State(std::make_unique<Inflation>())
  , Input(InputSize)
{
  if (inflateInit2(&this->State->Stream, MAX_WBITS + GzipOnly) != Z_OK)
  {
    throw std::bad_alloc();
  }
}

//----------------------------------------------------------------------------------------------------------------------
GzipDecoder::~GzipDecoder()
{
  inflateEnd(&this->State->Stream);
}

//----------------------------------------------------------------------------------------------------------------------
std::size_t GzipDecoder::Read(char* bytes, std::size_t count)
{
  z_stream& stream = this->State->Stream;
  const std::size_t most = std::min<std::size_t>(count, std::numeric_limits<uInt>::max());
  stream.next_out = reinterpret_cast<Bytef*>(bytes);
  stream.avail_out = static_cast<uInt>(most);
  while (stream.avail_out > 0 && !this->IsAtEnd && this->Problem.empty())
  {
    this->Advance();
  }
  const std::size_t made = most - stream.avail_out;
  if (made == 0 && !this->Problem.empty())
  {
    throw InputError(this->Problem);
  }
  return made;
}

//----------------------------------------------------------------------------------------------------------------------
void GzipDecoder::Advance()
{
  z_stream& stream = this->State->Stream;
  if (stream.avail_in == 0 && !this->Fill())
  {
    return;
  }
  if (!this->IsInMember)
  {
    this->FindMember();
    return;
  }
  const int result = inflate(&stream, Z_NO_FLUSH);
  if (result == Z_MEM_ERROR)
  {
    throw std::bad_alloc();
  }
  if (result == Z_STREAM_END)
  {
    this->IsInMember = false;
  }
  else if (result != Z_OK)
  {
    this->SetProblem(std::string("damaged compressed data (") + (stream.msg ? stream.msg : "not those of gzip") +
      "), expected what gzip wrote");
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// Takes the next compressed bytes. False when there are none.
bool GzipDecoder::Fill()
{
  this->Compressed->read(this->Input.data(), static_cast<std::streamsize>(this->Input.size()));
  const auto count = static_cast<std::size_t>(this->Compressed->gcount());
  this->BytesTaken += static_cast<std::int64_t>(count);
  this->State->Stream.next_in = reinterpret_cast<Bytef*>(this->Input.data());
  this->State->Stream.avail_in = static_cast<uInt>(count);
  if (count == 0 && this->Compressed->bad())
  {
    this->SetProblem("reading failed, expected the rest of the compressed data");
  }
  else if (count == 0 && this->IsInMember)
  {
    this->SetProblem("end of file, expected the rest of the compressed data");
  }
  else if (count == 0)
  {
    this->IsAtEnd = true;
  }
  return count > 0;
}

//----------------------------------------------------------------------------------------------------------------------
/// Looks at the bytes behind a member: the next one begins, or nothing but zeros follows.
void GzipDecoder::FindMember()
{
  z_stream& stream = this->State->Stream;
  for (; stream.avail_in > 0 && *stream.next_in == 0; --stream.avail_in, ++stream.next_in)
  {
    this->IsInPadding = true;
  }
  if (stream.avail_in == 0)
  {
    return;
  }
  if (this->IsInPadding || static_cast<char>(*stream.next_in) != Magic[0])
  {
    this->SetProblem("more bytes after the compressed data, expected the end of the file");
    return;
  }
  inflateReset(&stream);
  this->IsInMember = true;
}

//----------------------------------------------------------------------------------------------------------------------
void GzipDecoder::SetProblem(const std::string& text)
{
  this->Problem = "byte " + std::to_string(this->Position()) + ": " + text;
}

//----------------------------------------------------------------------------------------------------------------------
/// The number of compressed bytes that were used.
std::int64_t GzipDecoder::Position() const
{
  return this->BytesTaken - std::int64_t(this->State->Stream.avail_in);
}

//----------------------------------------------------------------------------------------------------------------------
double GzipDecoder::PartRead() const
{
  return SeismicHorizons::PartRead(*this->Compressed, static_cast<double>(this->Position()), this->CompressedSize);
}

//----------------------------------------------------------------------------------------------------------------------
void GzipDecoder::Rewind()
{
  this->Compressed->clear();
  this->Compressed->seekg(0);
  inflateReset(&this->State->Stream);
  this->State->Stream.avail_in = 0;
  this->BytesTaken = 0;
  this->IsInMember = true;
  this->IsInPadding = false;
  this->IsAtEnd = false;
  this->Problem.clear();
}
}
