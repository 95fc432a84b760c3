// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultLineFile.h"

#include "Common/Text/InputFile.h"
#include "Common/Text/LineBuffer.h"
#include "Common/Text/OtherFormats.h"
#include "FaultLineFormats.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
bool IsOfGOCAD(std::string_view firstLine)
{
  return ToLower(firstLine.substr(0, 5)) == "gocad";
}

/// Creates the parser at the first line that is neither empty nor a comment.
class LineDealer
{
public:
  std::unique_ptr<FaultLineParser> Parser;
  std::int64_t Lines = 0;

  /// The beginning of the file says what the columns are.
  LineDealer(std::string_view beginning, const FaultTextOptions& options)
    : Beginning(beginning)
    , Options(options)
  {
  }

  void Deal(std::string_view text)
  {
    text = this->Lines == 0 ? WithoutByteOrderMark(text) : text;
    while (!text.empty())
    {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const NumberedLine line = { text.substr(0, end), ++this->Lines };
      if (!this->Parser && !IsSkipped(line.Text))
      {
        this->Parser = this->MakeParser(Trim(line.Text));
      }
      if (this->Parser)
      {
        this->Parser->Take(line);
      }
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }

private:
  std::unique_ptr<FaultLineParser> MakeParser(std::string_view firstLine) const
  {
    if (IsOfGOCAD(firstLine))
    {
      return MakePLineParser();
    }
    if (StartsWith(firstLine, "@"))
    {
      return MakeZmapLineParser();
    }
    if (StartsWith(firstLine, "PROFILE"))
    {
      return MakeIesxLineParser();
    }
    TextLines lines = SplitLines(WithoutByteOrderMark(this->Beginning));
    if (std::all_of(lines.begin(), lines.end(), IsSkipped))
    {
      lines = { firstLine }; // Comments are longer than the beginning.
    }
    return MakePlainLineParser(FindFaultColumns(lines, this->Options), NullValues(this->Options.NullValues));
  }

  const std::string_view Beginning;
  const FaultTextOptions Options;
};

std::string_view FirstLine(std::string_view text)
{
  while (!text.empty() && IsSkipped(text.substr(0, text.find('\n'))))
  {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return text.substr(0, text.find('\n'));
}

constexpr std::size_t MostFields = 6; // of points without names: fault, stick, node, x, y and z

/// Looks for marks that only files of fault lines have; lines of x y z alone may be picks.
bool HasMark(std::string_view text)
{
  const std::string_view first = Trim(FirstLine(text));
  if (IsOfGOCAD(first))
  {
    return ToLower(Trim(first.substr(5))).substr(0, 5) == "pline";
  }
  if (StartsWith(first, "PROFILE"))
  {
    return first.find("TYPE 1") == std::string_view::npos; // Horizons are of that type.
  }
  if (StartsWith(first, "@") || StartsWith(first, "->") || StartsWith(first, "FFASCI") ||
    StartsWith(first, "INLINE-") || StartsWith(first, "CROSSLINE-"))
  {
    return true;
  }
  // A file of picks may end with the mark of IRAP, so that another line has to follow it.
  bool hasEnd = false;
  while (!text.empty())
  {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (hasEnd && !IsSkipped(line))
    {
      return true;
    }
    hasEnd = hasEnd || IsEndOfPart(line);
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return false;
}
}

//----------------------------------------------------------------------------------------------------------------------
double ReadFinite(std::string_view field, std::int64_t line, const char* what)
{
  double value = 0.0;
  if (ReadNumber(field, value) != NumberKind::Finite)
  {
    throw ErrorAt(line, Quote(field) + ", expected a finite number, " + what);
  }
  return value;
}

//----------------------------------------------------------------------------------------------------------------------
bool BeginsAsFaultLines(std::istream& stream)
{
  const std::string text = PeekLines(stream);
  if (text.find('\0') != std::string::npos || !HasMark(text))
  {
    return false;
  }
  LineDealer dealer(text, {});
  dealer.Deal(text);
  if (IsOfGOCAD(Trim(FirstLine(text))))
  {
    return true; // Polylines may start anywhere in the file.
  }
  const FaultLineFile file = dealer.Parser->Finish();
  // ZMAP+ files of points without segments are no fault lines.
  return !file.Ends.empty() && (!StartsWith(Trim(FirstLine(text)), "@") || !file.Sticks.front().empty());
}

//----------------------------------------------------------------------------------------------------------------------
bool IsFaultTable(std::istream& stream)
{
  const std::string text = PeekLines(stream);
  if (text.find('\0') != std::string::npos)
  {
    return false;
  }
  const TextLines lines = SplitLines(WithoutByteOrderMark(text));
  try
  {
    const FaultColumns columns = FindFaultColumns(lines, {});
    return columns.SaysFaults ||
      (columns.HeaderLines == 0 && columns.Roles.size() <= MostFields && columns.Find(FaultRole::Stick) >= 0);
  }
  catch (const InputError&)
  {
    return false;
  }
}

//----------------------------------------------------------------------------------------------------------------------
FaultLineFile ReadFaultLines(
  std::istream& stream, const FaultTextOptions& options, const Monitor& monitor, std::size_t bufferSize)
{
  constexpr std::size_t lookedAt = 256 * 1024;
  const std::string beginning = PeekLines(stream, lookedAt);
  if (!StartsWith(beginning, "GOCAD")) // GOCAD files may begin with other objects.
  {
    RefuseOtherFormats(beginning, "fault lines as text");
  }
  LineBuffer lines(stream, bufferSize);
  LineDealer dealer(beginning, options);
  while (!lines.AtEnd())
  {
    if (!lines.Read())
    {
      throw ErrorAt(dealer.Lines + 1, "reading failed, expected the rest of the file");
    }
    const auto size = static_cast<std::size_t>(lines.Last() - lines.First());
    // At the end of the file LineBuffer adds a newline.
    dealer.Deal(std::string_view(lines.First(), lines.AtEnd() ? size - 1 : size));
    monitor.Progress(lines.PartRead());
  }
  if (!dealer.Parser)
  {
    throw CutOffAt(std::max<std::int64_t>(1, dealer.Lines), "end of file, expected fault lines");
  }
  FaultLineFile file = dealer.Parser->Finish();
  if (file.Ends.empty())
  {
    throw CutOffAt(dealer.Lines, "end of file, expected a fault line of two points at least");
  }
  return file;
}
}
