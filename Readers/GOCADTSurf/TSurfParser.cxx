// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Splits a file into objects and blocks; TSurfBuilder takes the lines of a TSurf.

#include "TSurfParser.h"

#include "Common/Text/InputFile.h"
#include "Common/Text/LineBuffer.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/OtherFormats.h"
#include "TSurfBuilder.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t HeadSize = 4096; // bytes
constexpr const char* ExpectedObject = ", expected \"GOCAD TSurf 1\"";

bool SaysNothing(const LineTokens& line)
{
  return line.AtEnd() || *line.Here() == '#';
}

std::string_view TakeKeyword(LineTokens& line)
{
  const char* const first = line.Here();
  const std::string_view keyword = line.Next();
  const std::size_t brace = keyword.find('{');
  if (brace == std::string_view::npos || brace == 0)
  {
    return keyword;
  }
  line.MoveTo(first + brace);
  return keyword.substr(0, brace);
}

bool IsGOCAD(std::string_view keyword)
{
  return keyword.size() == 5 && (keyword.front() == 'G' || keyword.front() == 'g') && ToLower(keyword) == "gocad";
}

constexpr std::string_view Coordinates = "GOCAD_ORIGINAL_COORDINATE_SYSTEM";

enum class BlockKind
{
  Header,
  CoordinateSystem,
  Unknown
};

/// Returns the word that ends a block, or an empty text. Words within a block, such as END, have no meaning outside.
std::string EndOfBlock(std::string_view keyword, std::string_view rest)
{
  constexpr std::string_view begin = "BEGIN_";
  if (keyword == Coordinates)
  {
    return "END_ORIGINAL_COORDINATE_SYSTEM";
  }
  if (keyword == "PROPERTY_CN")
  {
    return "END_PROPERTY_CN";
  }
  if (StartsWith(keyword, begin))
  {
    return "END_" + std::string(keyword.substr(begin.size()));
  }
  return !rest.empty() && rest.back() == '{' ? "}" : "";
}

class ObjectParser
{
public:
  std::vector<TSurf> Surfaces;
  TSurfList List;

  explicit ObjectParser(TSurfChoice choice, const char* type)
    : Choice(std::move(choice))
    , Type(type)
  {
  }

  /// Lines must be complete.
  void ParseLines(const char* text, const char* last)
  {
    while (text != last)
    {
      this->ParseLine(text);
      text = std::char_traits<char>::find(text, static_cast<std::size_t>(last - text), '\n') + 1;
      ++this->Line;
    }
  }

  void Finish() const
  {
    const std::int64_t last = std::max<std::int64_t>(this->Line - 1, 1);
    if (this->BlockLine != 0)
    {
      throw CutOffAt(last,
        "end of file, expected " + Quote(this->BlockEnd) + " of the block of line " + std::to_string(this->BlockLine));
    }
    if (this->ObjectLine != 0 || !this->GroupLines.empty())
    {
      const std::int64_t object = this->ObjectLine != 0 ? this->ObjectLine : this->GroupLines.back();
      throw CutOffAt(last, "end of file, " + ExpectedEnd(object));
    }
    if (this->List.Names.empty())
    {
      throw ErrorAt(last,
        (this->List.OtherObjects == 0 ? "empty file"
                                      : std::to_string(this->List.OtherObjects) + " GOCAD objects of other types") +
          ExpectedObject);
    }
  }

  std::int64_t NextLine() const { return this->Line; }

private:
  std::string_view InCapitals(std::string_view keyword)
  {
    const auto isSmall = [](char c) { return c >= 'a' && c <= 'z'; };
    if (std::none_of(keyword.begin(), keyword.end(), isSmall))
    {
      return keyword;
    }
    this->Capitals = keyword;
    for (char& c : this->Capitals)
    {
      c = isSmall(c) ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return this->Capitals;
  }

  void ParseLine(const char* text)
  {
    LineTokens line(text);
    if (SaysNothing(line))
    {
      return;
    }
    if (this->BlockLine != 0)
    {
      this->ParseBlockLine(line);
      return;
    }
    const std::string_view keyword = this->InCapitals(TakeKeyword(line));
    if (IsGOCAD(keyword))
    {
      this->StartObject(line);
    }
    else if (this->ObjectLine == 0 && keyword == "END_MEMBERS" && !this->GroupLines.empty())
    {
      this->ObjectLine = this->GroupLines.back();
      this->GroupLines.pop_back();
      this->IsTSurf = false;
    }
    else if (this->ObjectLine == 0)
    {
      throw ErrorAt(this->Line, Quote(LineTokens(text).Rest()) + ExpectedObject);
    }
    else if (keyword == "END")
    {
      this->EndObject();
    }
    else if (!(this->Builder && this->Builder->TakeGeometry(keyword, line, this->Line)))
    {
      this->ParseDescription(keyword, line);
    }
  }

  void StartObject(LineTokens& line)
  {
    const std::string_view type = line.Next();
    if (this->ObjectLine != 0)
    {
      throw ErrorAt(this->Line, Quote("GOCAD " + std::string(type)) + ", " + ExpectedEnd(this->ObjectLine));
    }
    this->ObjectLine = this->Line;
    this->IsTSurf = ToLower(type) == this->Type;
    this->Header = TSurfHeader();
    if (this->IsTSurf && this->Choice(this->List.Names.size()))
    {
      this->Builder.emplace();
    }
  }

  void EndObject()
  {
    if (this->Builder)
    {
      this->Surfaces.push_back(this->Builder->Finish(std::move(this->Header)));
      this->Builder.reset();
      this->List.Names.push_back(this->Surfaces.back().Name);
    }
    else if (this->IsTSurf)
    {
      this->List.Names.push_back(this->Header.Name);
    }
    else
    {
      ++this->List.OtherObjects;
    }
    if (this->IsTSurf)
    {
      this->List.Lines.push_back(this->Line - this->ObjectLine);
    }
    this->ObjectLine = 0;
  }

  static std::string ExpectedEnd(std::int64_t line)
  {
    return "expected END of the GOCAD object of line " + std::to_string(line);
  }

  /// A block may open here.
  void ParseDescription(std::string_view keyword, LineTokens& line)
  {
    const std::string_view rest = line.Rest();
    const bool isHeader = keyword == "HEADER" || (keyword == "{" && this->HeaderLine != 0);
    const std::string end = keyword == "{" ? "}" : EndOfBlock(keyword, rest);
    this->HeaderLine = keyword == "HEADER" && rest.empty() ? this->Line : 0;
    this->IsHeaderOpen = false;
    if (keyword == "BEGIN_MEMBERS" && !this->IsTSurf)
    {
      this->GroupLines.push_back(this->ObjectLine); // Members of a group are objects, as outside.
      this->ObjectLine = 0;
    }
    else if (!end.empty())
    {
      this->BlockEnd = end;
      this->BlockLine = this->Line;
      this->Block = isHeader     ? BlockKind::Header
        : keyword == Coordinates ? BlockKind::CoordinateSystem
                                 : BlockKind::Unknown;
    }
    else if (isHeader && rest.size() >= 2 && rest.front() == '{' && rest.back() == '}')
    {
      this->Header.Take(rest.substr(1, rest.size() - 2));
    }
    else if (isHeader && !rest.empty() && rest.front() == '{')
    {
      this->Header.Take(rest.substr(1));
      this->IsHeaderOpen = true;
      this->BlockEnd = "}";
      this->BlockLine = this->Line;
      this->Block = BlockKind::Header;
    }
    else if (this->Builder)
    {
      this->Builder->TakeOfProperties(keyword, line, this->Line);
    }
  }

  void ParseBlockLine(LineTokens& line)
  {
    const std::string_view text = line.Rest();
    const std::string_view keyword = this->InCapitals(line.Next());
    if (keyword == this->BlockEnd)
    {
      this->BlockLine = 0;
    }
    else if (this->Block == BlockKind::Header)
    {
      const bool isLast = this->IsHeaderOpen && text.back() == '}'; // Otherwise the brace belongs to the value.
      this->Header.Take(text.substr(0, text.size() - (isLast ? 1 : 0)));
      this->BlockLine = isLast ? 0 : this->BlockLine;
    }
    else if (this->Block == BlockKind::CoordinateSystem && this->Builder)
    {
      this->Builder->TakeOfCoordinates(keyword, line, this->Line);
    }
  }

  const TSurfChoice Choice;
  const char* const Type; // in lower case
  std::int64_t Line = 1;
  std::string Capitals;
  std::int64_t ObjectLine = 0; // first line of the object; 0 outside
  std::int64_t BlockLine = 0; // first line of the block; 0 outside
  std::string BlockEnd;
  BlockKind Block = BlockKind::Unknown;
  std::int64_t HeaderLine = 0; // Line of HEADER if its brace is on the next line, else 0.
  bool IsHeaderOpen = false; // Values follow the opening brace, and may precede the closing one.
  std::vector<std::int64_t> GroupLines; // first lines of open groups
  bool IsTSurf = false;
  TSurfHeader Header;
  std::optional<TSurfBuilder> Builder;
};

void SkipByteOrderMark(std::istream& stream)
{
  const std::istream::pos_type here = stream.tellg();
  std::array<char, ByteOrderMark.size()> mark = {};
  stream.read(mark.data(), mark.size());
  if (std::string_view(mark.data(), mark.size()) != ByteOrderMark)
  {
    stream.clear();
    stream.seekg(here);
  }
}

/// Returns the type in lower case, or nothing for other formats.
std::optional<std::string> FirstTypeOf(const std::string& head)
{
  const std::string text = head + '\n';
  for (std::size_t start = 0; start < text.size(); start = text.find('\n', start) + 1)
  {
    LineTokens line(text.data() + start);
    if (!SaysNothing(line))
    {
      return IsGOCAD(line.Next()) ? std::optional(ToLower(line.Next())) : std::nullopt;
    }
  }
  return std::nullopt;
}

ObjectParser ParseObjects(
  std::istream& stream, const TSurfChoice& choice, const Monitor& monitor, std::size_t bufferSize, const char* type)
{
  ObjectParser parser(choice, type);
  const std::string head = PeekText(stream, HeadSize);
  if (!FirstTypeOf(head))
  {
    // Files of other formats may have no newline; their first lines suffice for the error.
    const std::size_t newline = head.rfind('\n');
    const std::string text = head.substr(0, newline) + '\n';
    ObjectParser(choice, type).ParseLines(text.data(), text.data() + text.size());
  }
  SkipByteOrderMark(stream);
  LineBuffer lines(stream, bufferSize);
  while (!lines.AtEnd())
  {
    if (!lines.Read())
    {
      throw ErrorAt(parser.NextLine(), "reading failed, expected the rest of the file");
    }
    parser.ParseLines(lines.First(), lines.Last());
    monitor.Progress(lines.PartRead());
  }
  // The type may be truncated.
  if (parser.List.Names.empty() && !StartsWith(type, FirstTypeOf(head).value_or("")))
  {
    RefuseOtherFormats(head, "a surface of GOCAD (TSurf)");
  }
  parser.Finish();
  return parser;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<std::string> FirstTypeOfGOCAD(std::istream& stream)
{
  return FirstTypeOf(PeekText(stream, HeadSize));
}

//----------------------------------------------------------------------------------------------------------------------
TSurfList ListTSurfs(std::istream& stream, const Monitor& monitor, std::size_t bufferSize)
{
  return ParseObjects(
    stream, [](std::size_t) { return false; }, monitor, bufferSize, "tsurf")
    .List;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<TSurf> LoadTSurfs(
  std::istream& stream, const TSurfChoice& choice, const Monitor& monitor, std::size_t bufferSize, const char* type)
{
  return ParseObjects(stream, choice, monitor, bufferSize, type).Surfaces;
}
}
