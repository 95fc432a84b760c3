// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a file is cut into buffers and blocks, and the number of threads, do not matter; progress and stop.

#include "Common/Base/Errors.h"
#include "Common/Base/Parallel.h"
#include "Common/Survey/StrayPicks.h"
#include "TextTables.h"
#include "Tools/Check.h"
#include "Tools/MonitorChecker.h"

using namespace TextTables;

namespace
{
/// What comes of a file, as text: its picks or an error.
std::string Outcome(const std::string& text, const TextPieces& pieces)
{
  try
  {
    return ToText(Read(text, TextOptions(), pieces));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
}

std::vector<std::string> Texts()
{
  std::vector<std::string> texts;
  for (const Sample& sample : Samples())
  {
    texts.push_back(sample.Text);
    texts.push_back("\xEF\xBB\xBF" + sample.Text.substr(0, sample.Text.size() - 20));
  }
  texts.push_back("1.5 2 3\n1.5 3 4\nEOB\n\n#\nEOB\n");
  texts.push_back("1.5 2 3\n1.5 3 4\nEOB\n\n\n1.5 2 a\n");
  texts.push_back("1.5 2 3\n1.5 3 a\n1.5 4 b\n");
  texts.push_back("a 1 2 3.5\nb 1 2 3.5\na 1 3 3.5\nc 1 4 3.5\nb 1 5 3.5\n");
  return texts;
}

void TestSizes()
{
  for (const std::string& text : Texts())
  {
    const std::string whole = Outcome(text, TextPieces());
    for (const std::size_t buffer : { 1, 2, 7, 31, 64, 200 })
    {
      for (const std::size_t block : { 1, 5, 40, 1000 })
      {
        CHECK_EQUAL(Outcome(text, { buffer, block }), whole);
      }
    }
  }
}

std::string ManyPicks()
{
  std::string text;
  for (int n = 0; n < 20000; ++n)
  {
    text += "Horizon" + std::to_string(n % 7) + " " + std::to_string(n / 100 + 1) + " " + std::to_string(n % 100 + 1) +
      " " + std::to_string(0.25 * n) + "\n";
  }
  return text;
}

void TestThreads()
{
  const std::string text = ManyPicks();
  const int usual = Detail::NumberOfThreads();
  Detail::NumberOfThreads() = 1;
  const std::string alone = Outcome(text, { 100000, 1000 });
  CHECK_EQUAL(alone == Outcome(text, TextPieces()), true);
  for (const int threads : { 2, 5 })
  {
    Detail::NumberOfThreads() = threads;
    CHECK(Outcome(text, { 100000, 1000 }) == alone);
    CHECK_EQUAL(Outcome(text + "x\ny\n", { 100000, 1000 }).substr(0, 22), std::string("line 20001: 1 fields, "));
  }
  Detail::NumberOfThreads() = usual;
}

/// The line of each pick, wherever a file is cut.
void TestLines()
{
  std::string text;
  std::vector<std::int64_t> expected;
  for (std::int64_t line = 1; line <= 3000; ++line)
  {
    const bool isPick = line % 1000 < 990 && line % 7 != 0;
    text += isPick ? "1 " + std::to_string(line) + " 5\n" : "#\n";
    if (isPick)
    {
      expected.push_back(line);
    }
  }
  for (const TextPieces& pieces : { TextPieces(), TextPieces{ 1000, 100 }, TextPieces{ 300, 1000 } })
  {
    const PickTable picks = Read(text, TextOptions(), pieces);
    CHECK_EQUAL(picks.Size(), expected.size());
    for (std::size_t pick = 0; pick < picks.Size(); ++pick)
    {
      CHECK_EQUAL(PicksText(picks, { pick }), "line " + std::to_string(expected[pick]));
    }
  }
}

void TestMonitor()
{
  const std::string text = ManyPicks();
  const TextLayout layout = Layout(text);
  const auto read = [&](const Monitor& monitor)
  {
    std::istringstream stream(text);
    ReadPicks(stream, layout, monitor, { 20000, 1000 });
  };
  CHECK_EQUAL(MonitorChecker::Check(10, read), std::string());
}
}

int TestTextPieces(int, char*[])
{
  TestSizes();
  TestThreads();
  TestLines();
  TestMonitor();
  return Check::Result();
}
