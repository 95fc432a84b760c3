// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseMatrixParser.h"

#include "ColumnParser.h"
#include "Common/LineBuffer.h"
#include "Common/LineErrors.h"
#include "Common/Parallel.h"
#include "Common/TextNumbers.h"
#include "Common/TextWords.h"
#include "HorizonCollector.h"
#include "VerticalFit.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
constexpr const char* ExpectedHeader = ", expected three positive integers \"nX nY nZ\"";
constexpr std::int64_t HeaderLines = 1;
constexpr std::size_t BlockSize = 256 * 1024; // bytes that a thread parses at a time
constexpr std::size_t MaximumHeader = 4096; // characters, the end of the line included

/// Whether the number of cells fits into 63 bits.
bool IsCountable(const SparseMatrixSize& size)
{
  const std::int64_t columns = std::int64_t(size[0]) * size[1];
  return columns <= std::numeric_limits<std::int64_t>::max() / size[2];
}

/// Takes the first line, without byte order mark and with a newline at its end.
SparseMatrixSize ParseHeader(const std::string& line)
{
  const std::string header = "header " + Quote(std::string_view(line).substr(0, line.size() - 1));
  SparseMatrixSize size = {};
  const char* text = SkipBlanks(line.c_str());
  for (int& n : size)
  {
    const std::string_view token = TokenAt(text);
    n = ReadPositiveInteger(token);
    text = SkipBlanks(text + token.size());
  }
  if (*std::min_element(size.begin(), size.end()) == 0 || *text != '\n')
  {
    throw ErrorAt(1, header + ExpectedHeader);
  }
  if (!IsCountable(size))
  {
    throw ErrorAt(1, header + ", expected a product below 2^63");
  }
  return size;
}

/// Parses the lines of a file piece by piece, and each piece block by block on all threads.
class PieceParser
{
public:
  PieceParser(const SparseMatrixSize& size, const SparseMatrixOptions& options)
    : Size(size)
    , Options(options)
  {
  }

  void Parse(std::string_view lines)
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
    this->Horizons.Add(this->Parsed, blocks.size());
  }

  /// The number of the line that comes next.
  std::int64_t NextLine() const { return HeaderLines + this->Lines + 1; }

  /// For the end of the file.
  std::vector<HorizonVoxels> Take()
  {
    const std::int64_t columns = std::int64_t(this->Size[0]) * this->Size[1];
    if (this->Lines < columns)
    {
      throw ErrorAt(HeaderLines + this->Lines,
        "end of file after " + std::to_string(this->Lines) + " columns, expected " + std::to_string(columns));
    }
    return this->Horizons.Take(this->Options.SmallestSize);
  }

private:
  /// How many lines come before each block.
  std::vector<std::int64_t> CountLinesBefore(const std::vector<std::string_view>& blocks)
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

  const SparseMatrixSize Size;
  const SparseMatrixOptions Options;
  std::int64_t Lines = 0; // parsed so far
  std::vector<HorizonSorter> Parsed; // for each block of a piece
  HorizonCollector Horizons;
};
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixSize ReadSparseMatrixHeader(std::istream& stream)
{
  // A file of another kind may have no newline at all, so the search for it is limited.
  std::array<char, MaximumHeader> text;
  stream.getline(text.data(), text.size());
  if (stream.bad())
  {
    throw ErrorAt(1, std::string("reading failed") + ExpectedHeader);
  }
  const bool isComplete = stream.good();
  const std::size_t length = static_cast<std::size_t>(stream.gcount()) - (isComplete ? 1 : 0);
  const std::string line(WithoutByteOrderMark(std::string_view(text.data(), length)));
  if (!isComplete && line.empty())
  {
    throw ErrorAt(1, std::string("empty file") + ExpectedHeader);
  }
  if (!isComplete && !stream.eof())
  {
    throw ErrorAt(1, "header " + Quote(line) + ExpectedHeader);
  }
  return ParseHeader(line + '\n');
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrix ReadSparseMatrix(
  std::istream& stream, const SparseMatrixOptions& options, const Monitor& monitor, std::size_t bufferSize)
{
  SparseMatrix matrix;
  matrix.Size = ReadSparseMatrixHeader(stream);
  LineBuffer lines(stream, bufferSize);
  PieceParser pieces(matrix.Size, options);
  while (!lines.AtEnd())
  {
    const bool isRead = lines.Read();
    pieces.Parse(std::string_view(lines.First(), std::size_t(lines.Last() - lines.First())));
    if (!isRead)
    {
      throw ErrorAt(pieces.NextLine(), "reading failed, expected the rest of the file");
    }
    monitor.Progress(lines.PartRead());
  }
  matrix.Horizons = pieces.Take();
  matrix.VerticalFit = FitVertically(matrix.Horizons);
  return matrix;
}
}
