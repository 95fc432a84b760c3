// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultLineFile.h"

#include "Common/LineBuffer.h"
#include "FaultLineFormats.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
std::unique_ptr<FaultLineParser> MakeParser(std::string_view firstLine)
{
  const std::string_view text = Trim(firstLine);
  return StartsWith(text, "GOCAD") ? MakePLineParser()
    : StartsWith(text, "@")        ? MakeZmapLineParser()
                                   : MakePlainLineParser();
}

/// Gives lines to a parser, which is made for the first that says anything.
class LineDealer
{
public:
  std::unique_ptr<FaultLineParser> Parser;
  std::int64_t Lines = 0; // that were dealt

  void Deal(std::string_view text)
  {
    text = this->Lines == 0 ? WithoutByteOrderMark(text) : text;
    while (!text.empty())
    {
      const std::size_t end = std::min(text.find('\n'), text.size());
      const NumberedLine line = { text.substr(0, end), ++this->Lines };
      if (!this->Parser && !IsSkipped(line.Text))
      {
        this->Parser = MakeParser(line.Text);
      }
      if (this->Parser)
      {
        this->Parser->Take(line);
      }
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }
};
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
FaultLineFile ReadFaultLines(std::istream& stream, const Monitor& monitor, std::size_t bufferSize)
{
  LineBuffer lines(stream, bufferSize);
  LineDealer dealer;
  while (!lines.AtEnd())
  {
    if (!lines.Read())
    {
      throw ErrorAt(dealer.Lines + 1, "reading failed, expected the rest of the file");
    }
    const auto size = static_cast<std::size_t>(lines.Last() - lines.First());
    dealer.Deal(std::string_view(lines.First(), lines.AtEnd() ? size - 1 : size)); // without a newline that was added
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
