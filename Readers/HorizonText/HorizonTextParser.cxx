// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonTextParser.h"

#include "Common/LineBuffer.h"
#include "Common/LineErrors.h"
#include "Common/Parallel.h"
#include "Common/Survey/PickPlacement.h"
#include "Common/TextWords.h"
#include "IesxParser.h"
#include "PickBlock.h"
#include "PickCollector.h"

#include <string>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t LookAhead = 256 * 1024; // bytes that the layout is found from

/// Calls take(lines) with some complete lines after the other.
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

/// The text from the line behind the first `count` ones; those left out are taken off the count.
std::string_view SkipLines(std::string_view text, std::int64_t& count)
{
  while (count > 0 && !text.empty())
  {
    text.remove_prefix(text.find('\n') + 1);
    --count;
  }
  return text;
}

PickTable ReadColumns(std::istream& stream, const TextLayout& layout, const Monitor& monitor, const TextPieces& pieces)
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
      const bool isFirst = picks.Size() == 0;
      for (const PickBlock& block : parsed)
      {
        picks.Add(block);
      }
      if (isFirst && partRead > 0.0)
      {
        // A little more than it will take, so that columns need not grow, for which they would be in memory twice.
        picks.Reserve(std::size_t(1.05 * double(picks.Size()) / partRead));
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

/// The complete lines of the beginning of a file, each with its end; the last line of a short one gets one. Goes back
/// to the beginning.
std::string ReadBeginning(std::istream& stream)
{
  std::string text(LookAhead, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  const bool isWhole = stream.eof();
  stream.clear();
  stream.seekg(0);
  if (text.find('\0') != std::string::npos)
  {
    throw InputError("bytes of 0, expected text");
  }
  if (isWhole && !text.empty() && text.back() != '\n')
  {
    text += '\n';
  }
  text.resize(text.rfind('\n') + 1); // 0 where there is none
  return text;
}

TextLines SplitLines(std::string_view text)
{
  TextLines lines;
  while (!text.empty())
  {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  return lines;
}
}

//----------------------------------------------------------------------------------------------------------------------
TextLayout ReadTextLayout(std::istream& stream, const TextOptions& options)
{
  const std::string text = ReadBeginning(stream);
  return FindTextLayout(SplitLines(WithoutByteOrderMark(text)), options);
}

//----------------------------------------------------------------------------------------------------------------------
void CheckFirstPicks(std::istream& stream, const TextLayout& layout)
{
  const std::string text = ReadBeginning(stream);
  std::int64_t headerLines = layout.HeaderLines;
  const std::string_view lines = SkipLines(WithoutByteOrderMark(text), headerLines);
  if (layout.Kind == TextKind::Iesx)
  {
    IesxParser(layout).Parse(lines);
    return;
  }
  PickCollector picks(layout);
  picks.Add(ParsePicks(lines, layout));
  if (layout.IsGuessed && layout.HasLineOfNames)
  {
    throw InputError("names over the columns that do not say where picks are, expected those of a horizon");
  }
  if (layout.IsGuessed && layout.Find(ColumnRole::Inline) < 0)
  {
    PlacePicks(picks.Take(), PlacementOptions());
  }
}

//----------------------------------------------------------------------------------------------------------------------
PickTable ReadPicks(std::istream& stream, const TextLayout& layout, const Monitor& monitor, const TextPieces& pieces)
{
  return layout.Kind == TextKind::Iesx ? ReadIesx(stream, layout, monitor, pieces)
                                       : ReadColumns(stream, layout, monitor, pieces);
}
}
