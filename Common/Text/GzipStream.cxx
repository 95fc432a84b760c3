// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// zlib decodes and checks the members of the file block by block; a thread decodes the next block ahead. Two blocks of
// some megabytes are in memory.
//
// zlib's gzread would silently ignore data after a member: rubbish, a member of a single byte, and members after zeros.
// If a checksum is wrong, it also loses the text before it.

#include "GzipStream.h"

#include "FileErrors.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <future>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<char, 2> Magic = { '\x1F', '\x8B' };
constexpr std::size_t InputSize = 64 * 1024;
// Readers recognise a file by this size, without a thread.
constexpr std::size_t FirstBlockSize = 256 * 1024;
// Readers parse this size at a time.
constexpr std::size_t GzipBlockSize = 4 * 1024 * 1024;

class GzipDecoder
{
public:
  explicit GzipDecoder(std::unique_ptr<std::istream> compressed)
    : Compressed(std::move(compressed))
    , CompressedSize(CountBytes(*this->Compressed))
    , Input(InputSize)
  {
    constexpr int gzipOnly = 16; // added to the window bits
    if (inflateInit2(&this->Inflation, MAX_WBITS + gzipOnly) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~GzipDecoder() { inflateEnd(&this->Inflation); }
  GzipDecoder(const GzipDecoder&) = delete;
  GzipDecoder& operator=(const GzipDecoder&) = delete;

  /// Returns less than `count` bytes only before the end or an error. Throws InputError if an error leaves no bytes.
  std::size_t Read(char* bytes, std::size_t count)
  {
    const std::size_t most = std::min<std::size_t>(count, std::numeric_limits<uInt>::max());
    this->Inflation.next_out = reinterpret_cast<Bytef*>(bytes);
    this->Inflation.avail_out = static_cast<uInt>(most);
    while (this->Inflation.avail_out > 0 && !this->Now.IsAtEnd && this->Now.Problem.empty())
    {
      this->Advance();
    }
    const std::size_t made = most - this->Inflation.avail_out;
    if (made == 0 && !this->Now.Problem.empty())
    {
      throw FileError(this->Now.IsCutOff ? FileProblem::CutOff : FileProblem::WrongContent, this->Now.Problem);
    }
    return made;
  }

  void Rewind()
  {
    this->Compressed->clear();
    this->Compressed->seekg(0);
    inflateReset(&this->Inflation);
    this->Inflation.avail_in = 0;
    this->Now = State();
  }

  double PartRead() const
  {
    return SeismicHorizons::PartRead(*this->Compressed, static_cast<double>(this->Position()), this->CompressedSize);
  }

private:
  struct State
  {
    std::int64_t BytesTaken = 0; // compressed bytes read from the stream
    bool IsInMember = true; // False between members and at the end.
    bool IsInPadding = false;
    bool IsAtEnd = false;
    bool IsCutOff = false; // The data are incomplete.
    std::string Problem; // Empty without an error.
  };

  void Advance()
  {
    if (this->Inflation.avail_in == 0 && !this->Fill())
    {
      return;
    }
    if (!this->Now.IsInMember)
    {
      this->FindMember();
      return;
    }
    const int result = inflate(&this->Inflation, Z_NO_FLUSH);
    if (result == Z_MEM_ERROR)
    {
      throw std::bad_alloc();
    }
    if (result == Z_STREAM_END)
    {
      this->Now.IsInMember = false;
    }
    else if (result != Z_OK)
    {
      const char* const message = this->Inflation.msg;
      this->SetProblem(std::string("damaged compressed data (") + (message ? message : "not those of gzip") +
        "), expected what gzip wrote");
    }
  }

  /// Returns false if there are no more bytes.
  bool Fill()
  {
    this->Compressed->read(this->Input.data(), static_cast<std::streamsize>(this->Input.size()));
    const std::streamsize count = this->Compressed->gcount();
    this->Now.BytesTaken += count;
    this->Inflation.next_in = reinterpret_cast<Bytef*>(this->Input.data());
    this->Inflation.avail_in = static_cast<uInt>(count);
    if (count > 0)
    {
      return true;
    }
    if (this->Compressed->bad())
    {
      this->SetProblem("reading failed, expected the rest of the compressed data");
    }
    else if (this->Now.IsInMember)
    {
      this->SetProblem("end of file, expected the rest of the compressed data");
      this->Now.IsCutOff = true;
    }
    this->Now.IsAtEnd = true;
    return false;
  }

  /// A further member may follow, or zeros only.
  void FindMember()
  {
    for (; this->Inflation.avail_in > 0 && *this->Inflation.next_in == 0; --this->Inflation.avail_in)
    {
      ++this->Inflation.next_in;
      this->Now.IsInPadding = true;
    }
    if (this->Inflation.avail_in == 0)
    {
      return;
    }
    if (this->Now.IsInPadding || static_cast<char>(*this->Inflation.next_in) != Magic[0])
    {
      this->SetProblem("more bytes after the compressed data, expected the end of the file");
      return;
    }
    inflateReset(&this->Inflation);
    this->Now.IsInMember = true;
  }

  void SetProblem(const std::string& text)
  {
    this->Now.Problem = "byte " + std::to_string(this->Position()) + ": " + text;
  }

  std::int64_t Position() const { return this->Now.BytesTaken - std::int64_t(this->Inflation.avail_in); }

  const std::unique_ptr<std::istream> Compressed;
  const double CompressedSize;
  z_stream Inflation = {};
  std::vector<char> Input;
  State Now;
};

class GzipBuffer : public DecodingBuffer
{
public:
  explicit GzipBuffer(std::unique_ptr<std::istream> compressed)
    : Decoder(std::move(compressed))
  {
  }

  double PartRead() const override { return this->Current.PartRead; }

protected:
  int_type underflow() override
  {
    if (this->gptr() == this->egptr())
    {
      this->TakeNext();
    }
    return this->gptr() == this->egptr() ? traits_type::eof() : traits_type::to_int_type(*this->gptr());
  }

  pos_type seekoff(off_type offset, std::ios_base::seekdir way, std::ios_base::openmode which) override
  {
    if (way == std::ios_base::end)
    {
      return pos_type(off_type(-1));
    }
    const off_type here = this->BytesBefore + (this->gptr() - this->eback());
    return this->seekpos(pos_type(way == std::ios_base::cur ? here + offset : offset), which);
  }

  pos_type seekpos(pos_type position, std::ios_base::openmode) override
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

private:
  struct Block
  {
    std::vector<char> Bytes;
    std::size_t Count = 0;
    double PartRead = 0.0;
  };

  Block Decode(std::vector<char> bytes, std::size_t size)
  {
    bytes.resize(size);
    const std::size_t count = this->Decoder.Read(bytes.data(), size);
    return { std::move(bytes), count, this->Decoder.PartRead() };
  }

  void TakeNext()
  {
    const bool isFirst = this->BytesBefore == 0 && this->Current.Count == 0;
    this->BytesBefore += this->egptr() - this->eback();
    this->setg(nullptr, nullptr, nullptr);
    std::vector<char> memory = std::move(this->Current.Bytes);
    this->Current =
      this->Next.valid() ? this->Next.get() : this->Decode(std::move(memory), isFirst ? FirstBlockSize : GzipBlockSize);
    char* const first = this->Current.Bytes.data();
    this->setg(first, first, first + this->Current.Count);
    if (!isFirst && this->Current.Count > 0)
    {
      // Without a free thread the block is decoded on demand.
      this->Next = std::async(std::launch::async | std::launch::deferred,
        [this, memory = std::move(memory)]() mutable { return this->Decode(std::move(memory), GzipBlockSize); });
    }
  }

  void Rewind()
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

  GzipDecoder Decoder;
  Block Current;
  off_type BytesBefore = 0; // Bytes before the current block.
  std::future<Block> Next; // Destroyed before the decoder, which it uses.
};
}

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
GzipStream::GzipStream(std::unique_ptr<std::istream> compressed)
  : std::istream(nullptr)
  , Buffer(std::make_unique<GzipBuffer>(std::move(compressed)))
{
  this->rdbuf(this->Buffer.get());
  this->exceptions(std::ios::badbit); // Passes on errors of the buffer.
}
}
