// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PieceParser.h"

#include "Common/Base/Parallel.h"
#include "Common/Text/LineErrors.h"
#include "Common/Text/TextNumbers.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t HeaderLines = 1;
constexpr std::size_t BlockSize = 256 * 1024; // bytes per task

constexpr std::size_t ValuesPerVoxel = 5;
constexpr std::array<const char*, ValuesPerVoxel> ValueNames = { "vertical index ", "surface ID ", "thickness ",
  "amplitude ", "real z " };

struct ColumnError
{
  std::int64_t Line = 0; // From 0, within the parsed lines.
  std::string Text;
};

/// Lines must be complete. Functions are inside the class so that compilers inline them, without which reading takes 10
/// % longer.
class ColumnParser
{
public:
  ColumnParser(const SparseMatrixSize& size, std::int64_t firstColumn, HorizonSorter& horizons)
    : Size(size)
    , NumberOfColumns(std::int64_t(size[0]) * size[1])
    , Column(firstColumn)
    , I(int(std::min(firstColumn, NumberOfColumns) % size[0]))
    , J(int(std::min(firstColumn, NumberOfColumns) / size[0]))
    , Horizons(horizons)
  {
  }

  std::optional<ColumnError> Parse(std::string_view lines)
  {
    std::int64_t line = 0;
    try
    {
      const char* text = lines.data();
      for (const char* const last = text + lines.size(); text != last; ++line)
      {
        text = this->Column < this->NumberOfColumns ? this->ParseColumn(text) : this->ParseRest(text);
      }
    }
    catch (const InputError& error)
    {
      return ColumnError{ line, error.what() };
    }
    return std::nullopt;
  }

private:
  const char* ParseColumn(const char* text)
  {
    this->Voxels.clear();
    text = SkipBlanks(text);
    while (*text != '\n')
    {
      text = this->ParseVoxel(text);
    }
    this->RequireOneVoxelPerCell();
    for (const SparseMatrixVoxel& voxel : this->Voxels)
    {
      this->Horizons.Add(this->I, this->J, voxel);
    }
    ++this->Column;
    if (++this->I == this->Size[0])
    {
      this->I = 0;
      ++this->J;
    }
    return text + 1;
  }

  const char* ParseRest(const char* text)
  {
    text = SkipBlanks(text);
    if (*text != '\n')
    {
      throw InputError(Quote(TokenAt(text)) + " after the last column, expected the end of the file");
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
    const char* const last = ReadShortInteger(text, value);
    if (last && value >= least && value <= largest)
    {
      return SkipBlanks(last);
    }
    return this->ParseRareInteger(text, position, least, largest, value);
  }

  const char* ParseRareInteger(const char* text, std::size_t position, int least, int largest, int& value)
  {
    double number = 0.0;
    const char* const next = this->ParseNumber(text, position, number);
    const bool inRange = number >= least && number <= largest; // Converting other numbers is undefined.
    value = inRange ? static_cast<int>(number) : 0;
    if (!inRange || value != number)
    {
      throw InputError(ValueNames[position] + Quote(TokenAt(text)) + ", expected an integer from " +
        std::to_string(least) + " to " + std::to_string(largest));
    }
    return next;
  }

  /// ReadPlainNumber refuses exponents, many digits, and text.
  const char* ParseRareNumber(const char* text, std::size_t position, double& value)
  {
    const std::string_view token = TokenAt(text);
    if (token.empty())
    {
      throw InputError(std::to_string(ValuesPerVoxel * (this->Voxels.size() - 1) + position) +
        " values, expected a multiple of " + std::to_string(ValuesPerVoxel));
    }
    const NumberKind kind = ReadAnyNumber(token, value);
    if (kind != NumberKind::Finite)
    {
      throw InputError(ValueNames[position] + Quote(token) +
        (kind == NumberKind::NotFinite ? ", expected a finite number" : ", expected a number"));
    }
    return text + token.size();
  }

  void RequireOneVoxelPerCell()
  {
    if (this->Voxels.size() < 2)
    {
      return;
    }
    this->Indices.clear();
    for (const SparseMatrixVoxel& voxel : this->Voxels)
    {
      this->Indices.push_back(voxel.VerticalIndex);
    }
    std::sort(this->Indices.begin(), this->Indices.end());
    const auto twice = std::adjacent_find(this->Indices.begin(), this->Indices.end());
    if (twice != this->Indices.end())
    {
      throw InputError("two voxels at vertical index " + std::to_string(*twice) + ", expected at most one in a cell");
    }
  }

  const SparseMatrixSize Size;
  const std::int64_t NumberOfColumns;
  std::int64_t Column; // columns before the current line
  int I;
  int J;
  std::vector<SparseMatrixVoxel> Voxels;
  std::vector<int> Indices;
  HorizonSorter& Horizons;
};

// ---- Collection of the voxels ------------------------------------------------------------------------------------
struct HorizonPart
{
  const LatticeHorizon* Part;
  LatticeHorizon* Whole;
  std::size_t First;
};

void Copy(const HorizonPart& part)
{
  const auto copy = [&part](const auto& from, auto& to)
  { std::copy(from.begin(), from.end(), to.begin() + part.First); };
  copy(part.Part->Column, part.Whole->Column);
  copy(part.Part->K, part.Whole->K);
  copy(part.Part->Thickness, part.Whole->Thickness);
  copy(part.Part->Amplitude, part.Whole->Amplitude);
  copy(part.Part->RealZ, part.Whole->RealZ);
}
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
        errors[block] = ColumnParser(this->Size, firstColumns[block], this->Parsed[block]).Parse(blocks[block]);
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
    throw CutOffAt(HeaderLines + this->Lines,
      "end of file after " + std::to_string(this->Lines) + " columns, expected " + std::to_string(columns));
  }
}

//----------------------------------------------------------------------------------------------------------------------
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

//----------------------------------------------------------------------------------------------------------------------
LatticeHorizon& HorizonCollector::HorizonOf(int surfaceId)
{
  const auto [place, isNew] = this->Positions.emplace(surfaceId, this->Horizons.size());
  if (isNew)
  {
    this->Horizons.emplace_back().SurfaceId = surfaceId;
  }
  return this->Horizons[place->second];
}

//----------------------------------------------------------------------------------------------------------------------
void HorizonCollector::Add(const std::vector<HorizonSorter>& blocks, std::size_t count, double partOfAll)
{
  constexpr double Margin = 1.03; // of what is expected
  constexpr double Most = 16.0; // times of what is there, as small horizons may lie in a small part of a file
  const double times = partOfAll > 0.0 && partOfAll < 1.0 ? std::min(Most, Margin / partOfAll) : 0.0;
  std::vector<HorizonPart> parts;
  for (std::size_t block = 0; block < count; ++block)
  {
    for (const LatticeHorizon& part : blocks[block].List())
    {
      if (!part.Column.empty())
      {
        LatticeHorizon& whole = this->HorizonOf(part.SurfaceId);
        parts.push_back({ &part, &whole, whole.Column.size() });
        whole.DroppedDuplicates += part.DroppedDuplicates;
        const std::size_t size = part.Column.size();
        const auto expected = std::size_t(times * double(whole.Column.size() + size));
        ForEachVoxelArray(whole, [&](auto& values) { values.Extend(size, expected); });
      }
    }
  }
  ParallelFor(std::int64_t(parts.size()), 1,
    [&parts](std::int64_t first, std::int64_t last)
    { std::for_each(parts.begin() + first, parts.begin() + last, Copy); });
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<LatticeHorizon> HorizonCollector::Take(std::int64_t smallestSize)
{
  std::vector<LatticeHorizon> horizons;
  for (LatticeHorizon& horizon : this->Horizons)
  {
    if (std::int64_t(horizon.Column.size()) >= smallestSize)
    {
      horizons.push_back(std::move(horizon));
    }
  }
  this->Horizons.clear();
  std::sort(horizons.begin(), horizons.end(),
    [](const LatticeHorizon& a, const LatticeHorizon& b) { return a.SurfaceId < b.SurfaceId; });
  return horizons;
}
}
