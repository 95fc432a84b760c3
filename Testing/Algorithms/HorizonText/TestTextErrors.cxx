// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every message, and files that are cut off or hold rubbish: an error, or the picks that are complete.

#include "Common/Base/Errors.h"
#include "TextTables.h"
#include "Tools/Check.h"

#include <cmath>
#include <optional>
#include <random>

using namespace TextTables;

namespace
{
TextOptions Given(const std::string& columns)
{
  TextOptions options;
  options.Columns = columns;
  return options;
}

void TestLayoutMessages()
{
  CHECK_THROWS_WITH(Read(""), "no picks after 0 lines, expected lines of numbers");
  CHECK_THROWS_WITH(Read("# nothing\n\n"), "no picks after 2 lines, expected lines of numbers");
  CHECK_THROWS_WITH(Read("EOB\n"), "no picks after 0 lines, expected");
  CHECK_THROWS_WITH(Read(std::string("1 2 3\n\0\n", 8)), "byte 6 is 0, so this is no text; expected lines of numbers");
  CHECK_THROWS_WITH(
    Read("  0\nSECTION\n"), "a drawing (DXF), expected points of horizons, a grid, a surface or a cube");
  CHECK_THROWS_WITH(Read("o top\nv 1 2 3\nv 2 2 3\nf 1 2 3\n"), "a triangle mesh (OBJ), expected points of horizons");
  CHECK_THROWS_WITH(
    Read(std::string("1\0 \0002\0 \0003\0\n\0", 12)), "text in UTF-16, expected UTF-8 or ASCII: convert the file");
  CHECK_THROWS_WITH(Read(std::string("\0001\0 \0002\0 \0003\0\n", 12)), "text in UTF-16, expected UTF-8 or ASCII");
  CHECK_THROWS_WITH(Read("1 2\n"), "columns Inline, Crossline, expected Z, and X and Y or Inline and Crossline");
  CHECK_THROWS_WITH(Read("Dear all, see you\n"), "expected Z, and X and Y or Inline and Crossline");
  CHECK_THROWS_WITH(Read("# 1: X\n# 2: Z\n3 4\n"), "columns X, Z, expected Z, and X and Y or Inline and Crossline");
  CHECK_THROWS_WITH(
    Read("# 1: X\n# 2: Y\n# 3: Z\n1.5 2 3 4\n"), "line 4: 4 fields, expected one for each of the columns X, Y, Z");
  CHECK_THROWS_WITH(
    Read("X,Y,Z,Dip\n\n1,2,3\n"), "line 3: 3 fields, expected one for each of the columns X, Y, Z, Dip");
  CHECK_THROWS_WITH(Read("X,Y,Z,H\xF6he,D" + std::string(1000, 'i') + "p\n1,2,3\n"),
    "columns X, Y, Z, H?he, D" + std::string(31, 'i') + "...");
}

void TestColumnMessages()
{
  CHECK_THROWS_WITH(Read("1 2 3\n", Given("X,Y,Z,X")), "columns X,Y,Z,X, expected X once");
  CHECK_THROWS_WITH(Read("1 2 3\n", Given("X,Y,Dip")), "columns X, Y, Dip, expected Z, and X and Y or");
  CHECK_THROWS_WITH(Read("1 2 3\n", Given("X,Inline,Z")), "columns X, Inline, Z, expected Z, and X and Y or");
  CHECK_THROWS_WITH(
    Read("\n1 2 3\n", Given("X,Y,Z,Dip")), "line 2: 3 fields, expected one for each of the columns X, Y, Z, Dip");
  CHECK_THROWS_WITH(Read("1 2 3 a\n1 2 3 b\n", Given("X,Y,Z,Dip")), "line 1: \"a\" as Attribute, expected a number");
}

void TestLineMessages()
{
  CHECK_THROWS_WITH(
    Read("1 2 3.5\n\n1 3\n"), "line 3: 2 fields, expected one for each of the columns Inline, Crossline, Z");
  CHECK_THROWS_WITH(Read("1 2 3.5\n1 3 4 5\n"), "line 2: 4 fields, expected one for each of the columns Inline");
  CHECK_THROWS_WITH(Read("1.5 2 3.5\n1 3 4x\n"), "line 2: \"4x\" as Z, expected a number");
  CHECK_THROWS_WITH(
    Read("1.5 2 3.5\n1 3 -1g\n"), "line 2: \"-1g\" as Z, expected a number; NullValues lists words for no value");
  CHECK_THROWS_WITH(Read("1.5 2 3.5\n1 3 inf\n"), "line 2: \"inf\" as Z, expected a number");
  CHECK_THROWS_WITH(Read("1.5 2 3.5\n1 3 1e400\n"), "line 2: \"1e400\" as Z, expected a number");
  CHECK_THROWS_WITH(
    Read("1.5 2 3.5\n* 3 4\n"), "line 2: \"*\" as X, expected a number: only Z and attributes may be missing");
  CHECK_THROWS_WITH(Read("1.5,2,3.5\n1,,4\n"), "line 2: \"\" as Y, expected a number: only Z and attributes may");
  CHECK_THROWS_WITH(Read("1.5,2,3.5\n1,2,\"4\n"), "line 2: \"\"4\" as Z, expected a number");
  CHECK_THROWS_WITH(Read("1.5 2 3.5\nEOB\n\n1 2 3\n"), "line 4: more lines after the end mark, expected none");
  CHECK_THROWS_WITH(Read("a 1 2 3.5\n\"a\x01\" 1 3 3.5\n"), "line 2: \"a?\" as name of a horizon, expected characters");
  CHECK_THROWS_WITH(Read("4 3 3\n0 0 1\n3 1 2\n"), "end of file after 2 picks, expected 3");
  CHECK_THROWS_WITH(Read("4 3 2\n0 0 1\n3 1 2\n2 2 3\n"), "end of file after 3 picks, expected 2");
}

void TestIesxMessages()
{
  const auto changed = [](const std::string& from, const std::string& to)
  {
    std::string text = OldIesx;
    return text.replace(text.find(from), from.size(), to);
  };
  CHECK_THROWS_WITH(Read(changed("TYPE 1", "TYPE 3")), "line 1: \"PROFILE Top Chalk        TYPE 3 ...\", expected a");
  CHECK_THROWS_WITH(
    Read(changed("   648.62", "      abc")), "line 3: \"abc\" as Z in the characters 39 to 47, expected");
  CHECK_THROWS_WITH(
    Read(changed(" I    376", " I  12:x1")), "line 3: \"12:x1\" as Inline in the characters 89 to 95, ");
  CHECK_THROWS_WITH(
    Read(changed("   914.00  ", "           ")), "as Crossline in the characters 48 to 57, expected a number");
  CHECK_THROWS_WITH(Read(changed(" I    376 XX", "NL-07::2    ")), "line 4: picks of 2D lines and of a 3D survey");
  CHECK_THROWS_WITH(Read(changed("EOD\n", "")), "end of file without a line EOD, expected one");
  CHECK_THROWS_WITH(Read(changed("EOD", "\t1x")), "line 5: \"1x\", expected z and the attribute of the pick before");
  CHECK_THROWS_WITH(Read(changed("SNAPPING", "\t1 2\nSNAPPING")), "line 2: \"1 2\", expected z and the attribute of");
}

/// Whether `part` has the first picks of `whole`. Of its last pick a number may differ: it may be cut off.
bool IsBeginning(const PickTable& part, const PickTable& whole, bool mayBeCut)
{
  const Columns some(part);
  const Columns all(whole);
  int differences = 0;
  if (part.Size() > whole.Size() || some.Values.size() > all.Values.size())
  {
    return false;
  }
  for (std::size_t column = 0; column < some.Values.size(); ++column)
  {
    for (std::size_t pick = 0; pick < part.Size(); ++pick)
    {
      const double value = (*some.Values[column])[pick];
      const double expected = (*all.Values[column])[pick];
      const bool isSame = value == expected || (std::isnan(value) && std::isnan(expected));
      differences += isSame ? 0 : 1;
      if (!isSame && pick + 1 < part.Size())
      {
        return false;
      }
    }
  }
  return differences <= (mayBeCut ? 1 : 0);
}

std::optional<PickTable> TryRead(const std::string& text)
{
  try
  {
    return Read(text);
  }
  catch (const InputError&)
  {
    return std::nullopt;
  }
}

void TestCutFiles()
{
  for (const Sample& sample : Samples())
  {
    const PickTable whole = Read(sample.Text);
    for (std::size_t size = 0; size < sample.Text.size(); ++size)
    {
      const std::optional<PickTable> part = TryRead(sample.Text.substr(0, size));
      const bool isWithinLine = size > 0 && sample.Text[size - 1] != '\n';
      if (!CHECK(!part || IsBeginning(*part, whole, isWithinLine)))
      {
        std::cerr << sample.Name << " cut after " << size << " bytes:\n" << ToText(*part);
      }
    }
  }
}

/// Bytes that are put into a file anywhere, or in place of others.
void TestRubbish()
{
  std::mt19937 random(1);
  const auto number = [&random](std::size_t limit) { return std::size_t(random()) % limit; };
  for (const Sample& sample : Samples())
  {
    for (int round = 0; round < 300; ++round)
    {
      std::string text = sample.Text;
      for (std::size_t change = number(4); change < 4; ++change)
      {
        const std::string bytes(number(3), char(number(256)));
        text.replace(number(text.size()), number(3), bytes);
      }
      TryRead(text);
    }
  }
  std::string bytes(20000, ' ');
  for (char& byte : bytes)
  {
    byte = char(1 + number(255));
  }
  CHECK(!TryRead(bytes));
}

void TestLongLines()
{
  CHECK_THROWS_WITH(Read(std::string(3000000, '7')), "no picks after 0 lines");
  CHECK_THROWS_WITH(Read("1.5 2 3\n1.5 2 " + std::string(9000000, '7') + "\n"),
    "line 2: \"77777777777777777777777777777777...\" as Z, expected a number");
  CHECK_EQUAL(Read("1.5 2 3\n1.5 3 4" + std::string(9000000, ' ') + "\n1.5 4 5\n").Size(), std::size_t(3));
  CHECK_EQUAL(Read("1.5 2 3\n" + std::string(1000000, '\n') + "1.5 4 5\n").Size(), std::size_t(2));
  CHECK_EQUAL(Read("# " + std::string(100000, 'x') + "\n1.5 2 3\n").Size(), std::size_t(1));
}
}

int TestTextErrors(int, char*[])
{
  TestLayoutMessages();
  TestColumnMessages();
  TestLineMessages();
  TestIesxMessages();
  TestCutFiles();
  TestRubbish();
  TestLongLines();
  return Check::Result();
}
