// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces of whole lines, however large they are and whichever thread reads them.

#include "Common/Base/Errors.h"
#include "Common/Text/LineBuffer.h"
#include "Tools/Check.h"
#include "Tools/Gzip.h"
#include "Tools/Patches.h"

#include <algorithm>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

using namespace SeismicHorizons;

namespace
{
// Pieces from the second to last on are read ahead.
constexpr std::size_t Sizes[] = { 1, 2, 7, 100, 4096, 65537, 100000, 4 * 1024 * 1024 };

/// Lines of any length, and now and then a very long one.
std::string MakeText(std::size_t size, Patches::Random& random)
{
  std::string text;
  while (text.size() < size)
  {
    const int length = random.Chance(0.01) ? random.Below(20000) : random.Below(60);
    text.append(std::size_t(length), char('a' + random.Below(26)));
    text += '\n';
  }
  if (random.Chance(0.5))
  {
    text += "no newline";
  }
  return text;
}

std::string ReadPieces(std::istream& stream, std::size_t size)
{
  std::string text;
  LineBuffer lines(stream, size);
  double part = 0.0;
  while (!lines.AtEnd())
  {
    CHECK(lines.Read());
    CHECK(lines.Last() > lines.First() && lines.Last()[-1] == '\n');
    CHECK(lines.PartRead() >= part);
    part = lines.PartRead();
    text.append(lines.First(), lines.Last());
  }
  CHECK(part == 1.0 || text == "\n");
  return text;
}

void TestText()
{
  Patches::Random random(3);
  for (const std::size_t length : { 0, 1, 1000, 300000 })
  {
    const std::string text = MakeText(length, random);
    for (const std::size_t size : Sizes)
    {
      std::istringstream stream(text);
      CHECK((length > 1000 && size < 100) || ReadPieces(stream, size) == text + '\n');
      CHECK(size < 4096 || ReadPieces(*Gzip::Open(Gzip::Compress(text)), size) == text + '\n');
    }
  }
}

/// Fails after a number of bytes.
class FailingBuffer : public std::stringbuf
{
public:
  FailingBuffer(const std::string& text, std::streamsize left)
    : std::stringbuf(text)
    , Left(left)
  {
  }

protected:
  std::streamsize xsgetn(char* bytes, std::streamsize count) override
  {
    if (count > this->Left)
    {
      throw std::runtime_error("broken");
    }
    this->Left -= count;
    return std::stringbuf::xsgetn(bytes, count);
  }

private:
  std::streamsize Left;
};

/// What was read comes first.
void TestFailure()
{
  Patches::Random random(5);
  const std::string text = MakeText(1000000, random);
  for (const std::size_t size : { 1000, 100000 })
  {
    FailingBuffer buffer(text, 500000);
    std::istream stream(&buffer);
    LineBuffer lines(stream, size);
    std::size_t length = 0;
    while (lines.Read())
    {
      length += std::size_t(lines.Last() - lines.First());
    }
    CHECK(!lines.AtEnd() && length > 300000 && length <= 500000);
  }
}

/// A buffer that goes early waits for its thread.
void TestAbandoned()
{
  Patches::Random random(7);
  const std::string text = MakeText(2000000, random);
  for (int run = 0; run < 50; ++run)
  {
    auto stream = std::make_unique<std::istringstream>(text);
    LineBuffer lines(*stream, 500000);
    CHECK(lines.Read());
  }
}

void TestLongLine()
{
  const std::string zeros = Gzip::Compress(std::string(std::size_t(1) << 27, '0'));
  for (const std::size_t size : { 100000, 1024 * 1024 })
  {
    const std::unique_ptr<std::istream> stream = Gzip::Open(zeros);
    LineBuffer lines(*stream, size);
    CHECK_THROWS_WITH(lines.Read(), "byte 0: a line of more than 67108863 bytes");
  }
}
}

int TestLineBuffer(int, char*[])
{
  TestText();
  TestFailure();
  TestAbandoned();
  TestLongLine();
  return Check::Result();
}
