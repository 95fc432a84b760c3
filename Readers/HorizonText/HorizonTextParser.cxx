// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonTextParser.h"

#include "Common/Base/Parallel.h"
#include "Common/Survey/PickWarnings.h"
#include "Common/Survey/VerticalSense.h"
#include "Common/Text/LineBuffer.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/OtherFormats.h"
#include "Common/Text/TextWords.h"
#include "PickBlock.h"
#include "Readers/GOCADTSurf/TSurfParser.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t LookAhead = 256 * 1024; // bytes

template <typename Take>
void ForEachPiece(std::istream& stream, std::size_t bufferSize, const Monitor& monitor, Take&& take)
{
  stream.clear();
  stream.seekg(0);
  LineBuffer lines(stream, bufferSize);
  for (bool isFirst = true; !lines.AtEnd(); isFirst = false)
  {
    if (!lines.Read())
    {
      throw InputError("reading failed");
    }
    const std::string_view text(lines.First(), std::size_t(lines.Last() - lines.First()));
    take(isFirst ? WithoutByteOrderMark(text) : text, lines.PartRead());
    monitor.Progress(lines.PartRead());
  }
}

class PickCollector
{
public:
  std::size_t Picks = 0;

  explicit PickCollector(const TextLayout& layout)
    : Layout(layout)
    , Lines(layout.HeaderLines)
  {
    this->Table.Survey = layout.Survey;
    this->Table.AreRows = layout.Kind == TextKind::Matrix;
    this->Table.AreLinesGuessed = layout.IsGuessed && layout.Find(FieldRole::Inline) >= 0;
    if (!layout.Doubt.empty())
    {
      this->Table.Warnings.push_back(layout.Doubt);
    }
    for (const TextColumn& column : layout.Columns)
    {
      if (column.Role == FieldRole::Z && IsElevation(column.Name))
      {
        this->Table.Survey.IsUpright = true;
      }
      if (column.Role == FieldRole::Attribute)
      {
        this->Table.Attributes.push_back({ column.Name, {} });
      }
    }
  }

  void Reserve(std::size_t picks)
  {
    for (std::size_t column = 0; column < this->Layout.Columns.size(); ++column)
    {
      const FieldRole role = this->Layout.Columns[column].Role;
      if (role == FieldRole::HorizonName)
      {
        this->Table.Horizon.reserve(picks);
      }
      else if (role != FieldRole::Ignored)
      {
        this->Column(column).reserve(picks);
      }
    }
  }

  /// Throws InputError for the first error of a block, and for lines after an end mark.
  void Add(const PickBlock& block)
  {
    if (this->HasEnded && block.FirstLine >= 0)
    {
      throw ErrorAt(this->Lines + block.FirstLine + 1, LinesAfterEnd);
    }
    if (block.ErrorLine >= 0)
    {
      const bool isFirst =
        this->Picks == 0 && block.ErrorLine == block.FirstLine && block.Error.find(": ") == std::string::npos;
      throw ErrorAt(
        this->Lines + block.ErrorLine + 1, block.Error + (isFirst ? "; HeaderLines skips lines above the picks" : ""));
    }
    // If each pick has the name of its horizon, headers between horizons add nothing.
    const bool isBetween = !this->Layout.HasNames() && (this->Picks > 0 || block.CommentLine > block.FirstLine);
    if (block.CommentLine >= 0 && isBetween && !std::exchange(this->HasComment, true))
    {
      this->Table.Warnings.push_back("comments between picks, the first in line " +
        std::to_string(this->Lines + block.CommentLine + 1) +
        ", are ignored: if they name horizons, put each horizon into its own file");
    }
    if (this->Layout.Kind == TextKind::Matrix)
    {
      this->AddRows(block);
      return;
    }
    std::size_t picks = block.Horizon.size();
    for (std::size_t column = 0; column < block.Values.size(); ++column)
    {
      const std::vector<double>& values = block.Values[column];
      if (!values.empty())
      {
        std::vector<double>& all = this->Column(column);
        all.insert(all.end(), values.begin(), values.end());
        picks = values.size();
      }
    }
    this->Nulls.insert(this->Nulls.end(), block.Nulls.begin(), block.Nulls.end());
    this->AddNames(block);
    this->AddLines(block);
    this->Table.OtherLines += block.OtherLines;
    this->Picks += picks;
    this->Lines += block.Lines;
    this->HasEnded = this->HasEnded || block.EndLine >= 0;
  }

  /// Throws InputError if the header states another number of picks.
  PickTable Take()
  {
    if (this->Layout.Picks >= 0 && this->Layout.Picks != std::int64_t(this->Picks))
    {
      throw CutOffAt(this->Lines,
        "end of file after " + std::to_string(this->Picks) + " picks, expected " + std::to_string(this->Layout.Picks));
    }
    if (this->Table.Names.empty())
    {
      this->Table.Names = { this->Layout.HorizonName };
    }
    this->CheckNames();
    WarnOfNulls(this->Nulls, this->Table.Z, this->Table.Warnings);
    return std::move(this->Table);
  }

private:
  std::vector<double>& Column(std::size_t column)
  {
    switch (this->Layout.Columns[column].Role)
    {
      case FieldRole::X:
        return this->Table.X;
      case FieldRole::Y:
        return this->Table.Y;
      case FieldRole::Z:
        return this->Table.Z;
      case FieldRole::Inline:
        return this->Table.Inline;
      case FieldRole::Crossline:
        return this->Table.Crossline;
      default:
        break;
    }
    std::size_t attribute = 0;
    for (std::size_t before = 0; before < column; ++before)
    {
      attribute += this->Layout.Columns[before].Role == FieldRole::Attribute ? 1 : 0;
    }
    return this->Table.Attributes[attribute].Values;
  }

  void AddRows(const PickBlock& block)
  {
    for (std::size_t column = 0; column < block.Values.size(); ++column)
    {
      double row = double(this->Picks);
      for (const double z : block.Values[column])
      {
        this->Table.Crossline.push_back(double(column));
        this->Table.Inline.push_back(row++);
        this->Table.Z.push_back(z);
      }
    }
    this->Picks += block.Values.front().size();
    this->Lines += block.Lines;
  }

  void AddNames(const PickBlock& block)
  {
    std::vector<int> numbers;
    for (const std::string& name : block.Names)
    {
      const auto [place, isNew] = this->Numbers.emplace(name, int(this->Table.Names.size()));
      if (isNew)
      {
        this->Table.Names.push_back(ToUtf8(name));
        if (this->Table.Names.back() != name && !std::exchange(this->IsLatin1, true))
        {
          this->Table.Warnings.push_back("horizon names are not in UTF-8 and are read as Latin-1, such as " +
            Quote(this->Table.Names.back()) + ": if they are in another encoding, convert the file, as with iconv");
        }
      }
      numbers.push_back(place->second);
    }
    for (const int number : block.Horizon)
    {
      this->Table.Horizon.push_back(numbers[number]);
    }
  }

  void AddLines(const PickBlock& block)
  {
    std::vector<PickLine>& lines = this->Table.Lines;
    for (const PickLine& picks : block.PickLines)
    {
      const PickLine next{ this->Picks + picks.Pick, this->Lines + picks.Line + 1 };
      if (lines.empty() || next.Line - lines.back().Line != std::int64_t(next.Pick - lines.back().Pick))
      {
        lines.push_back(next);
      }
    }
  }

  /// A text that differs in each line is not a name.
  void CheckNames()
  {
    const std::vector<int>& horizon = this->Table.Horizon;
    const std::vector<std::string>& names = this->Table.Names;
    constexpr std::size_t few = 20;
    if (names.size() > few && 2 * names.size() > horizon.size())
    {
      throw InputError(std::to_string(names.size()) + " names of horizons for " + std::to_string(horizon.size()) +
        " picks, expected several picks for each: set Columns, with - for columns to skip");
    }
    std::size_t changes = 0;
    for (std::size_t pick = 1; pick < horizon.size(); ++pick)
    {
      changes += horizon[pick] != horizon[pick - 1] ? 1 : 0;
    }
    if (names.size() > 1 && horizon.size() > few && 3 * changes > horizon.size())
    {
      this->Table.Warnings.push_back("horizon names change from line to line, such as " + Quote(names[0]) +
        " and " + Quote(names[1]) + ": if these are not horizon names, set Columns with - for them");
    }
  }

  const TextLayout& Layout;
  PickTable Table;
  std::int64_t Lines = 0; // before the next block
  bool HasEnded = false;
  bool HasComment = false;
  bool IsLatin1 = false; // A name is not UTF-8.
  std::unordered_map<std::string, int> Numbers;
  std::vector<double> Nulls;
};

std::string_view SkipLines(std::string_view text, std::int64_t& count)
{
  while (count > 0 && !text.empty())
  {
    text.remove_prefix(text.find('\n') + 1);
    --count;
  }
  return text;
}

PickTable ParsePickRows(
  std::istream& stream, const TextLayout& layout, const Monitor& monitor, const TextPieces& pieces)
{
  PickCollector picks(layout);
  std::int64_t headerLines = layout.HeaderLines;
  ForEachPiece(stream, pieces.Buffer, monitor,
    [&](std::string_view text, double partRead)
    {
      const std::vector<std::string_view> blocks = CutLines(SkipLines(text, headerLines), pieces.Block);
      std::vector<PickBlock> parsed(blocks.size());
      ParallelFor(std::int64_t(blocks.size()), 1,
        [&](std::int64_t first, std::int64_t last)
        {
          for (auto block = std::size_t(first); block < std::size_t(last); ++block)
          {
            parsed[block] = ParsePicks(blocks[block], layout);
          }
        });
      const bool isFirst = picks.Picks == 0;
      for (const PickBlock& block : parsed)
      {
        picks.Add(block);
      }
      if (isFirst && partRead > 0.0)
      {
        // A reserve of 5 % avoids growth, which would hold arrays in memory twice.
        picks.Reserve(std::size_t(1.05 * double(picks.Picks) / partRead));
      }
    });
  return picks.Take();
}

PickTable ReadIesx(std::istream& stream, const TextLayout& layout, const Monitor& monitor, const TextPieces& pieces)
{
  IesxParser picks(layout);
  std::int64_t headerLines = layout.HeaderLines;
  ForEachPiece(
    stream, pieces.Buffer, monitor, [&](std::string_view text, double) { picks.Parse(SkipLines(text, headerLines)); });
  return picks.Take();
}

/// The last line of a short file may lack its newline.
std::string ReadBeginning(std::istream& stream)
{
  std::string text(LookAhead, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  const bool isWhole = stream.eof();
  stream.clear();
  stream.seekg(0);
  RefuseOtherFormats(text, "points of horizons, a grid, a surface or a cube");
  if (IsUtf16(text))
  {
    throw InputError("text in UTF-16, expected UTF-8 or ASCII: convert the file");
  }
  if (text.find('\n') == std::string::npos && text.find('\r') != std::string::npos)
  {
    throw InputError("lines that end with carriage returns only, expected line feeds: convert them, as with mac2unix");
  }
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos)
  {
    throw InputError("byte " + std::to_string(zero) + " is 0, so this is no text; expected lines of numbers");
  }
  if (isWhole && !text.empty() && text.back() != '\n')
  {
    text += '\n';
  }
  text.resize(text.rfind('\n') + 1);
  return text;
}
}

//----------------------------------------------------------------------------------------------------------------------
TextLayout ReadTextLayout(std::istream& stream, const TextOptions& options)
{
  if (options.Columns.empty() && FirstTypeOfGOCAD(stream) == "vset")
  {
    TextLayout layout;
    layout.Kind = TextKind::VSet;
    layout.Nulls = NullValues(options.NullValues);
    layout.Columns = { { FieldRole::X, "X" }, { FieldRole::Y, "Y" }, { FieldRole::Z, "Z" } };
    return layout;
  }
  const std::string text = ReadBeginning(stream);
  return FindTextLayout(SplitLines(WithoutByteOrderMark(text)), options);
}

//----------------------------------------------------------------------------------------------------------------------
PickTable ReadFirstPicks(std::istream& stream, const TextLayout& layout)
{
  if (layout.Kind == TextKind::VSet)
  {
    return {};
  }
  const std::string text = ReadBeginning(stream);
  std::int64_t headerLines = layout.HeaderLines;
  const std::string_view lines = SkipLines(WithoutByteOrderMark(text), headerLines);
  if (layout.Kind == TextKind::Iesx)
  {
    IesxParser(layout).Parse(lines);
    return {};
  }
  TextLayout first = layout;
  first.Picks = -1; // The beginning has fewer picks than the file.
  PickCollector picks(first);
  picks.Add(ParsePicks(lines, first));
  return picks.Take();
}

//----------------------------------------------------------------------------------------------------------------------
PickTable ReadPicks(std::istream& stream, const TextLayout& layout, const Monitor& monitor, const TextPieces& pieces)
{
  return layout.Kind == TextKind::Iesx ? ReadIesx(stream, layout, monitor, pieces)
    : layout.Kind == TextKind::VSet    ? ReadVSets(stream, layout.Nulls, monitor)
                                       : ParsePickRows(stream, layout, monitor, pieces);
}
}
