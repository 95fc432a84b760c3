// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GzipStream.h"

#include <utility>

namespace SeismicHorizons
{
namespace
{
// As much as readers look at to recognise a file, so that this takes no thread, and no time for more.
constexpr std::size_t FirstBlockSize = 256 * 1024;
// As much as readers parse at a time, so that decoding and parsing take turns without waiting.
constexpr std::size_t BlockSize = 4 * 1024 * 1024;
}

//----------------------------------------------------------------------------------------------------------------------
GzipBuffer::GzipBuffer(std::unique_ptr<std::istream> compressed)
  : Decoder(std::move(compressed))
{
}

//----------------------------------------------------------------------------------------------------------------------
GzipBuffer::Block GzipBuffer::Decode(std::vector<char> bytes, std::size_t size)
{
  bytes.resize(size);
  const std::size_t count = this->Decoder.Read(bytes.data(), size);
  return { std::move(bytes), count, this->Decoder.PartRead() };
}

//----------------------------------------------------------------------------------------------------------------------
void GzipBuffer::DecodeAhead(std::vector<char> bytes)
{
  // Where no thread can be had, the block is decoded when it is asked for.
  this->Next = std::async(std::launch::async | std::launch::deferred,
    [this, memory = std::move(bytes)]() mutable { return this->Decode(std::move(memory), BlockSize); });
}

//----------------------------------------------------------------------------------------------------------------------
GzipBuffer::int_type GzipBuffer::underflow()
{
  if (this->gptr() == this->egptr())
  {
    const bool isFirst = this->BytesBefore == 0 && this->Current.Count == 0;
    this->BytesBefore += this->egptr() - this->eback();
    this->setg(nullptr, nullptr, nullptr); // also when there is an error
    std::vector<char> memory = std::move(this->Current.Bytes);
    this->Current =
      this->Next.valid() ? this->Next.get() : this->Decode(std::move(memory), isFirst ? FirstBlockSize : BlockSize);
    char* const first = this->Current.Bytes.data();
    this->setg(first, first, first + this->Current.Count);
    if (!isFirst && this->Current.Count > 0)
    {
      this->DecodeAhead(std::move(memory));
    }
  }
  return this->gptr() == this->egptr() ? traits_type::eof() : traits_type::to_int_type(*this->gptr());
}

//----------------------------------------------------------------------------------------------------------------------
void GzipBuffer::Rewind()
{
  if (this->Next.valid())
  {
    this->Next.wait();
    this->Next = std::future<Block>();
  }
  this->Decoder.Rewind();
  this->setg(nullptr, nullptr, nullptr);
  this->Current = Block();
  this->BytesBefore = 0;
}

//----------------------------------------------------------------------------------------------------------------------
GzipBuffer::pos_type GzipBuffer::seekoff(off_type offset, std::ios_base::seekdir way, std::ios_base::openmode which)
{
  if (way == std::ios_base::end)
  {
    return pos_type(off_type(-1));
  }
  const off_type here = this->BytesBefore + (this->gptr() - this->eback());
  return this->seekpos(pos_type(way == std::ios_base::cur ? here + offset : offset), which);
}

//----------------------------------------------------------------------------------------------------------------------
GzipBuffer::pos_type GzipBuffer::seekpos(pos_type position, std::ios_base::openmode)
{
  const auto target = off_type(position);
  if (target < 0)
  {
    return pos_type(off_type(-1));
  }
  if (target < this->BytesBefore)
  {
    this->Rewind();
  }
  while (target > this->BytesBefore + (this->egptr() - this->eback()))
  {
    this->setg(this->eback(), this->egptr(), this->egptr());
    if (this->underflow() == traits_type::eof())
    {
      return pos_type(off_type(-1));
    }
  }
  this->setg(this->eback(), this->eback() + (target - this->BytesBefore), this->egptr());
  return position;
}

//----------------------------------------------------------------------------------------------------------------------
GzipStream::GzipStream(std::unique_ptr<std::istream> compressed)
  : std::istream(nullptr)
  , Buffer(std::move(compressed))
{
  this->rdbuf(&this->Buffer);
  this->exceptions(std::ios::badbit); // passes errors of the buffer on
}
}
