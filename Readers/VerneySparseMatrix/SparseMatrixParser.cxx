// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The file is read in blocks. The complete lines of a block are parsed in place; what is left, the start of a line, is
// moved to the front of the block before the next one is read behind it. Every line that is parsed ends in a newline,
// also the last one, which gets one when the file lacks it. So no loop over characters needs to know where the block
// ends: a newline stops them all.

#include "SparseMatrixParser.h"

#include "SparseMatrixNumbers.h"
#include "SparseMatrixVisitors.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
// ---- Messages ----------------------------------------------------------------------------------------------------
constexpr std::size_t MaximumQuote = 32;
constexpr const char* ExpectedHeader = ", expected three positive integers \"nX nY nZ\"";

/// The text in quotes for a message, clipped, with a question mark for what can not be printed.
std::string Quote(std::string_view text)
{
  std::string quote(text.substr(0, MaximumQuote));
  std::replace_if(
    quote.begin(), quote.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return '"' + quote + (text.size() > MaximumQuote ? "...\"" : "\"");
}

InputError ErrorAt(std::int64_t line, const std::string& text)
{
  return InputError("line " + std::to_string(line) + ": " + text);
}

// ---- The header --------------------------------------------------------------------------------------------------
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

// ---- The columns -------------------------------------------------------------------------------------------------
constexpr std::size_t ValuesPerVoxel = 5;
constexpr std::array<const char*, ValuesPerVoxel> ValueNames = { "vertical index ", "surface ID ", "thickness ",
  "amplitude ", "real z " };

class ColumnParser
{
public:
  ColumnParser(const SparseMatrixSize& size, SparseMatrixVisitor& visitor)
    : Size(size)
    , NumberOfColumns(std::int64_t(size[0]) * size[1])
    , Visitor(visitor)
  {
  }

  /// Takes complete lines: the last character is a newline.
  void ParseLines(const char* text, const char* last)
  {
    while (text != last)
    {
      text = this->Column < this->NumberOfColumns ? this->ParseColumn(text) : this->ParseRest(text);
      ++this->Line;
    }
  }

  void RequireAllColumns() const
  {
    if (this->Column < this->NumberOfColumns)
    {
      throw ErrorAt(this->Line - 1,
        "end of file after " + std::to_string(this->Column) + " columns, expected " +
          std::to_string(this->NumberOfColumns));
    }
  }

  std::int64_t GetLine() const { return this->Line; }

private:
  // Each of these takes the text at the start of what it parses and returns where that ends.

  const char* ParseColumn(const char* text)
  {
    this->Voxels.clear();
    text = SkipBlanks(text);
    while (*text != '\n')
    {
      text = this->ParseVoxel(text);
    }
    if (!this->Voxels.empty())
    {
      this->RequireOneVoxelPerCell();
      this->Visitor.VisitColumn(this->I, this->J, this->Voxels);
    }
    ++this->Column;
    if (++this->I == this->Size[0])
    {
      this->I = 0;
      ++this->J;
    }
    return text + 1;
  }

  /// What follows the last column.
  const char* ParseRest(const char* text)
  {
    text = SkipBlanks(text);
    if (*text != '\n')
    {
      throw ErrorAt(this->Line, Quote(TokenAt(text)) + " after the last column, expected the end of the file");
    }
    return text + 1;
  }

  const char* ParseVoxel(const char* text)
  {
    SparseMatrixVoxel& voxel = this->Voxels.emplace_back();
    text = this->ParseInteger(text, 0, 0, this->Size[2] - 1, voxel.VerticalIndex);
    text =
      this->ParseInteger(text, 1, std::numeric_limits<int>::min(), std::numeric_limits<int>::max(), voxel.SurfaceId);
    text = this->ParseNumber(text, 2, voxel.Thickness);
    text = this->ParseNumber(text, 3, voxel.Amplitude);
    return this->ParseNumber(text, 4, voxel.RealZ);
  }

  const char* ParseNumber(const char* text, std::size_t position, double& value)
  {
    const char* last = ReadPlainNumber(text, value);
    if (!last)
    {
      last = this->ParseRareNumber(text, position, value);
    }
    return SkipBlanks(last);
  }

  const char* ParseInteger(const char* text, std::size_t position, int least, int largest, int& value)
  {
    double number = 0.0;
    const char* const next = this->ParseNumber(text, position, number);
    const bool inRange = number >= least && number <= largest; // only then may it be converted
    value = inRange ? static_cast<int>(number) : 0;
    if (!inRange || value != number)
    {
      throw ErrorAt(this->Line,
        ValueNames[position] + Quote(TokenAt(text)) + ", expected an integer from " + std::to_string(least) + " to " +
          std::to_string(largest));
    }
    return next;
  }

  /// A number that takes more than digits and a point, or none at all.
  const char* ParseRareNumber(const char* text, std::size_t position, double& value)
  {
    const std::string_view token = TokenAt(text);
    if (token.empty())
    {
      throw ErrorAt(this->Line,
        std::to_string(ValuesPerVoxel * (this->Voxels.size() - 1) + position) + " values, expected a multiple of " +
          std::to_string(ValuesPerVoxel));
    }
    const NumberKind kind = ReadAnyNumber(token, value);
    if (kind != NumberKind::Finite)
    {
      throw ErrorAt(this->Line,
        ValueNames[position] + Quote(token) +
          (kind == NumberKind::NotFinite ? ", expected a finite number" : ", expected a number"));
    }
    return text + token.size();
  }

  void RequireOneVoxelPerCell()
  {
    this->Indices.clear();
    for (const SparseMatrixVoxel& voxel : this->Voxels)
    {
      this->Indices.push_back(voxel.VerticalIndex);
    }
    std::sort(this->Indices.begin(), this->Indices.end());
    const auto twice = std::adjacent_find(this->Indices.begin(), this->Indices.end());
    if (twice != this->Indices.end())
    {
      throw ErrorAt(
        this->Line, "two voxels at vertical index " + std::to_string(*twice) + ", expected at most one in a cell");
    }
  }

  const SparseMatrixSize Size;
  const std::int64_t NumberOfColumns;
  SparseMatrixVisitor& Visitor;
  std::vector<SparseMatrixVoxel> Voxels; // of the column at hand
  std::vector<int> Indices; // theirs, sorted
  std::int64_t Line = 2;
  std::int64_t Column = 0;
  int I = 0;
  int J = 0;
};

// ---- The blocks --------------------------------------------------------------------------------------------------
/// The bytes from here to the end, or 0 when the stream can not tell.
double CountBytes(std::istream& stream)
{
  const std::istream::pos_type here = stream.good() ? stream.tellg() : std::istream::pos_type(-1);
  if (here == std::istream::pos_type(-1))
  {
    return 0.0;
  }
  stream.seekg(0, std::ios::end);
  const std::istream::pos_type end = stream.tellg();
  stream.seekg(here);
  return static_cast<double>(end - here);
}

/// Hands out a stream as pieces of complete lines.
class LineBlocks
{
public:
  LineBlocks(std::istream& stream, std::size_t blockSize)
    : Stream(stream)
    , Block(std::max<std::size_t>(blockSize, 2)) // room for one character and a newline
  {
  }

  bool AtEnd() const { return this->Stream.eof(); }
  double GetBytesRead() const { return static_cast<double>(this->BytesRead); }

  /// The complete lines.
  const char* First() const { return this->Block.data(); }
  const char* Last() const { return this->Block.data() + this->Complete; }

  /// Moves on to the next lines, unless at the end. False when reading failed.
  bool Read()
  {
    std::copy(this->Last(), this->First() + this->Filled, this->Block.data());
    this->Filled -= this->Complete;
    this->Complete = 0;
    while (this->Complete == 0)
    {
      if (!this->ReadMore())
      {
        return false;
      }
    }
    return true;
  }

private:
  /// Reads behind the start of a line, and ends the last line of the file.
  bool ReadMore()
  {
    if (this->Filled + 1 == this->Block.size())
    {
      this->Block.resize(2 * this->Block.size());
    }
    this->Stream.read(
      this->Block.data() + this->Filled, static_cast<std::streamsize>(this->Block.size() - this->Filled - 1));
    const auto count = static_cast<std::size_t>(this->Stream.gcount());
    const auto fresh = std::make_reverse_iterator(this->Block.begin() + static_cast<std::ptrdiff_t>(this->Filled));
    this->Filled += count;
    this->BytesRead += count;
    if (this->Stream.eof())
    {
      this->Block[this->Filled++] = '\n';
    }
    const auto last = std::make_reverse_iterator(this->Block.begin() + static_cast<std::ptrdiff_t>(this->Filled));
    const auto newline = std::find(last, fresh, '\n');
    this->Complete = newline == fresh ? 0 : static_cast<std::size_t>(newline.base() - this->Block.begin());
    return this->Stream.good() || this->Stream.eof();
  }

  std::istream& Stream;
  std::vector<char> Block;
  std::size_t Filled = 0;
  std::size_t Complete = 0;
  std::size_t BytesRead = 0;
};
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixSize ReadSparseMatrixHeader(std::istream& stream)
{
  // A file of another kind may have no newline at all, so the search for it is limited.
  std::array<char, 4096> text;
  stream.getline(text.data(), text.size());
  if (stream.bad())
  {
    throw ErrorAt(1, std::string("reading failed") + ExpectedHeader);
  }
  const bool isComplete = stream.good();
  std::string line(text.data(), static_cast<std::size_t>(stream.gcount()) - (isComplete ? 1 : 0));
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (line.compare(0, byteOrderMark.size(), byteOrderMark) == 0)
  {
    line.erase(0, byteOrderMark.size());
  }
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
SparseMatrixSize ParseSparseMatrix(
  std::istream& stream, SparseMatrixVisitor& visitor, const Monitor& monitor, std::size_t blockSize)
{
  const SparseMatrixSize size = ReadSparseMatrixHeader(stream);
  const double numberOfBytes = CountBytes(stream);
  ColumnParser columns(size, visitor);
  LineBlocks blocks(stream, blockSize);
  while (!blocks.AtEnd())
  {
    const bool isRead = blocks.Read();
    columns.ParseLines(blocks.First(), blocks.Last());
    if (!isRead)
    {
      throw ErrorAt(columns.GetLine(), "reading failed, expected the rest of the file");
    }
    monitor.Progress(numberOfBytes > 0.0 ? std::min(1.0, blocks.GetBytesRead() / numberOfBytes) : 0.0);
  }
  columns.RequireAllColumns();
  return size;
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrixSummary ScanSparseMatrix(std::istream& stream, const Monitor& monitor, std::size_t blockSize)
{
  CountingVisitor visitor;
  const SparseMatrixSize size = ParseSparseMatrix(stream, visitor, monitor, blockSize);
  return { size, visitor.GetCounts(), visitor.GetVerticalFit() };
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrix LoadSparseMatrix(std::istream& stream, const SparseMatrixCounts& horizons, DuplicatePolicy policy,
  const Monitor& monitor, std::size_t blockSize)
{
  LoadingVisitor visitor(horizons, policy);
  const SparseMatrixSize size = ParseSparseMatrix(stream, visitor, monitor, blockSize);
  return { size, visitor.TakeHorizons() };
}
}
