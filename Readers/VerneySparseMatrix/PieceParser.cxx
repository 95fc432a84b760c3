// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceParser.h"

#include "ColumnParser.h"
#include "Common/LineErrors.h"
#include "Common/Parallel.h"

#include <algorithm>
#include <optional>
#include <string>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t HeaderLines = 1;
constexpr std::size_t BlockSize = 256 * 1024; // bytes that a thread parses at a time
}

//----------------------------------------------------------------------------------------------------------------------
void PieceParser::ParseAll(
  LineBuffer& lines, const Monitor& monitor, const Taker& take, const std::function<bool(std::int64_t)>& goOn)
{
  while (!lines.AtEnd())
  {
    const bool isRead = lines.Read();
    if (!goOn(this->Lines))
    {
      return;
    }
    this->Parse(std::string_view(lines.First(), std::size_t(lines.Last() - lines.First())), take);
    if (!isRead)
    {
      throw ErrorAt(HeaderLines + this->Lines + 1, "reading failed, expected the rest of the file");
    }
    monitor.Progress(lines.PartRead());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PieceParser::Parse(std::string_view lines, const Taker& take)
{
  const std::vector<std::string_view> blocks = CutLines(lines, BlockSize);
  const std::vector<std::int64_t> firstColumns = this->CountLinesBefore(blocks);
  std::vector<std::optional<ColumnError>> errors(blocks.size());
  this->Parsed.resize(std::max(this->Parsed.size(), blocks.size()), HorizonSorter(this->Options));
  ParallelFor(std::int64_t(blocks.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto block = std::size_t(first); block < std::size_t(last); ++block)
      {
        this->Parsed[block].Clear();
        errors[block] = ParseColumns(blocks[block], this->Size, firstColumns[block], this->Parsed[block]);
      }
    });
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    if (errors[block])
    {
      throw ErrorAt(HeaderLines + firstColumns[block] + errors[block]->Line + 1, errors[block]->Text);
    }
  }
  take(this->Parsed, blocks.size());
}

//----------------------------------------------------------------------------------------------------------------------
void PieceParser::RequireEnd() const
{
  const std::int64_t columns = std::int64_t(this->Size[0]) * this->Size[1];
  if (this->Lines < columns)
  {
    throw ErrorAt(HeaderLines + this->Lines,
      "end of file after " + std::to_string(this->Lines) + " columns, expected " + std::to_string(columns));
  }
}

//----------------------------------------------------------------------------------------------------------------------
/// How many lines come before each block.
std::vector<std::int64_t> PieceParser::CountLinesBefore(const std::vector<std::string_view>& blocks)
{
  std::vector<std::int64_t> lines(blocks.size());
  ParallelFor(std::int64_t(blocks.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto block = std::size_t(first); block < std::size_t(last); ++block)
      {
        lines[block] = CountLines(blocks[block]);
      }
    });
  for (std::int64_t& count : lines)
  {
    this->Lines += count;
    count = this->Lines - count;
  }
  return lines;
}
}
