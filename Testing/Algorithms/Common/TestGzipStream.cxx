// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Streams of compressed data: what they give, how they go back, and what they refuse. Texts are longer than the blocks
// that are decoded at a time, where that matters.

#include "Common/Base/Errors.h"
#include "Common/Text/InputFile.h"
#include "Common/Text/StreamProgress.h"
#include "Tools/Check.h"
#include "Tools/Gzip.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace SeismicHorizons;

namespace
{
/// Text that does not compress well, so that there are many compressed bytes.
std::string MakeText(std::size_t size)
{
  std::string text;
  text.reserve(size + 20);
  std::uint64_t state = 1;
  while (text.size() < size)
  {
    state = state * 6364136223846793005u + 1442695040888963407u;
    text += std::to_string(state >> 20) + '\n';
  }
  return text;
}

const std::string Small = MakeText(1000);
const std::string Large = MakeText(11 * 1024 * 1024); // three blocks and a half
const std::string LargeCompressed = Gzip::Compress(Large);

std::string ReadAll(std::istream& stream)
{
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

std::string Decode(const std::string& compressed)
{
  return ReadAll(*Gzip::Open(compressed));
}

/// The text of `count` bytes from where the stream is.
std::string Read(std::istream& stream, std::size_t count)
{
  std::string text(count, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(count));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

// ---- What is read ------------------------------------------------------------------------------------------------
void TextComesBack()
{
  CHECK(Decode(Gzip::Compress("")).empty());
  CHECK(Decode(Gzip::Compress(Small)) == Small);
  CHECK(Decode(LargeCompressed) == Large);
  // As much as a block, and a byte less and more.
  for (const std::size_t size : { 256u * 1024 - 1, 256u * 1024, 256u * 1024 + 1, 4352u * 1024, 4352u * 1024 + 1 })
  {
    CHECK(Decode(Gzip::Compress(Large.substr(0, size))) == Large.substr(0, size));
  }
}

void SeveralMembersAreOne()
{
  const std::string empty = Gzip::Compress("");
  const std::string small = Gzip::Compress(Small);
  CHECK(Decode(small + small) == Small + Small);
  CHECK(Decode(empty + small + empty + LargeCompressed + small) == Small + Large + Small);
}

void ZerosMayFollow()
{
  CHECK(Decode(Gzip::Compress(Small) + std::string(1, '\0')) == Small);
  CHECK(Decode(Gzip::Compress(Small) + std::string(200000, '\0')) == Small);
}

void StreamsGoBack()
{
  const auto stream = Gzip::Open(LargeCompressed);
  CHECK(stream->tellg() == std::istream::pos_type(0));
  CHECK(Read(*stream, 100) == Large.substr(0, 100));
  CHECK(stream->tellg() == std::istream::pos_type(100));
  stream->seekg(7); // in the block at hand
  CHECK(Read(*stream, 5000000) == Large.substr(7, 5000000));
  stream->seekg(-10, std::ios::cur);
  CHECK(Read(*stream, 20) == Large.substr(4999997, 20));
  stream->seekg(300000); // in a block that is gone
  CHECK(Read(*stream, 20) == Large.substr(300000, 20));
  stream->seekg(9000000); // in one that is to come
  CHECK(stream->tellg() == std::istream::pos_type(9000000));
  CHECK(ReadAll(*stream) == Large.substr(9000000));
  stream->clear();
  stream->seekg(0);
  CHECK(ReadAll(*stream) == Large);
  stream->clear();
  stream->seekg(std::streamoff(Large.size()) + 1);
  CHECK(stream->fail());
  stream->clear();
  stream->seekg(0, std::ios::end);
  CHECK(stream->fail());
}

void ProgressIsThatOfTheCompressedBytes()
{
  const auto stream = Gzip::Open(LargeCompressed);
  CHECK_EQUAL(CountBytes(*stream), 0.0);
  CHECK(stream->good());
  double last = 0.0;
  for (std::size_t read = 0; read < Large.size(); read += 100000)
  {
    Read(*stream, 100000);
    const double part = PartRead(*stream, double(read), 0.0);
    CHECK(part >= last && part <= 1.0);
    // A block is at most 4 MB ahead of what was read.
    CHECK(std::abs(part - double(read) / double(Large.size())) < 4.2 / 11.0);
    last = part;
  }
  CHECK_EQUAL(last, 1.0);
  CHECK(PartRead(*Gzip::Open(Gzip::Compress(Small)), 0.0, 0.0) == 0.0);
}

// ---- What is refused ---------------------------------------------------------------------------------------------
/// Checks the message, and that all that comes before the fault is read, and reading again is refused again.
void CheckRefused(const std::string& compressed, const std::string& before, const std::string& message)
{
  const auto stream = Gzip::Open(compressed);
  CHECK(Read(*stream, before.size()) == before);
  CHECK_THROWS_WITH(Read(*stream, 1), message);
  stream->clear();
  CHECK_THROWS_WITH(Read(*stream, 1), message);
  stream->clear();
  stream->seekg(0);
  CHECK(Read(*stream, before.size()) == before);
}

void CutDataAreRefused()
{
  const std::string compressed = Gzip::Compress(Small);
  for (std::size_t size = 0; size < compressed.size(); ++size)
  {
    CHECK_THROWS_WITH(Decode(compressed.substr(0, size)),
      "byte " + std::to_string(size) + ": end of file, expected the rest of the compressed data");
    if (size > 0)
    {
      CHECK_THROWS_WITH(Decode(compressed + compressed.substr(0, size)),
        "byte " + std::to_string(compressed.size() + size) + ": end of file, expected the rest");
    }
  }
  // Without its checksum there is all of the text, but it is not known to be right.
  CheckRefused(compressed.substr(0, compressed.size() - 8), Small, "end of file");
  CheckRefused(LargeCompressed.substr(0, LargeCompressed.size() - 1), Large, "end of file");
  const std::string half = LargeCompressed.substr(0, LargeCompressed.size() / 2);
  CHECK_THROWS_WITH(Decode(half), "byte " + std::to_string(half.size()) + ": end of file, expected the rest");
}

void DamagedDataAreRefused()
{
  const std::string compressed = Gzip::Compress(Small);
  std::size_t harmless = 0;
  for (std::size_t bit = 0; bit < 8 * compressed.size(); ++bit)
  {
    std::string damaged = compressed;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    std::string text;
    try
    {
      text = Decode(damaged);
      CHECK(text == Small); // a time or an operating system in the header
      ++harmless;
    }
    catch (const InputError& error)
    {
      CHECK(std::string(error.what()).find("byte ") == 0);
      CHECK(std::string(error.what()).find(", expected ") != std::string::npos);
    }
  }
  CHECK(harmless >= 6 * 8 && harmless <= 7 * 8); // of time, flags of the compression, operating system, "is text"
  std::string wrong = compressed;
  wrong[wrong.size() - 8] = static_cast<char>(~wrong[wrong.size() - 8]);
  CheckRefused(wrong, Small, "damaged compressed data (incorrect data check), expected what gzip wrote");
  wrong = compressed;
  wrong.back() = '\x7F';
  CheckRefused(wrong, Small, "damaged compressed data (incorrect length check), expected what gzip wrote");
  CheckRefused("\x1F\x8B\x07" + std::string(10, 'x'), "",
    "damaged compressed data (unknown compression method), expected what gzip wrote");
}

void WhatFollowsIsChecked()
{
  const std::string compressed = Gzip::Compress(Small);
  const std::string message = "byte " + std::to_string(compressed.size()) +
    ": more bytes after the compressed data, expected the end of the file";
  CheckRefused(compressed + "x", Small, message);
  CheckRefused(compressed + Small, Small, message);
  CheckRefused(compressed + std::string(3, '\0') + compressed, Small, "more bytes after the compressed data");
  CheckRefused(compressed + "\x1F", Small, "end of file, expected the rest of the compressed data");
  CheckRefused(compressed + "\x1Fx", Small, "damaged compressed data (incorrect header check), expected");
}

// ---- Files -------------------------------------------------------------------------------------------------------
void FilesAreRecognisedByTheirContent()
{
  const std::string folder = std::filesystem::absolute("TestGzipStream").u8string();
  std::filesystem::create_directories(folder);
  const auto open = [&folder](const std::string& name, const std::string& bytes)
  {
    std::ofstream(folder + '/' + name, std::ios::binary) << bytes;
    return ReadAll(*OpenInputFile(folder + '/' + name));
  };
  CHECK(open("plain.gz", Small) == Small);
  CHECK(open("compressed.vsm", Gzip::Compress(Small)) == Small);
  CHECK(open("empty.gz", "").empty());
  CHECK(open("short.gz", "\x1F") == "\x1F");
  std::filesystem::remove_all(folder);
}

void StemsAreThoseOfTheFileWithin()
{
  CHECK_EQUAL(StemOf("b/a.vsm"), "a");
  CHECK_EQUAL(StemOf("b/a.vsm.gz"), "a");
  CHECK_EQUAL(StemOf("b/a.b.vsm.GZ"), "a.b");
  CHECK_EQUAL(StemOf("b/a.gz"), "a");
  CHECK_EQUAL(StemOf("b.gz/a"), "a");
}
}

int TestGzipStream(int, char*[])
{
  TextComesBack();
  SeveralMembersAreOne();
  ZerosMayFollow();
  StreamsGoBack();
  ProgressIsThatOfTheCompressedBytes();
  CutDataAreRefused();
  DamagedDataAreRefused();
  WhatFollowsIsChecked();
  FilesAreRecognisedByTheirContent();
  StemsAreThoseOfTheFileWithin();
  return Check::Result();
}
