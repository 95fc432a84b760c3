// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SparseMatrixParser.h"

#include "ColumnParser.h"
#include "Common/LineBuffer.h"
#include "Common/LineErrors.h"
#include "Common/TextNumbers.h"
#include "CountingVisitor.h"
#include "LoadingVisitor.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

namespace SeismicHorizons
{
namespace
{
constexpr const char* ExpectedHeader = ", expected three positive integers \"nX nY nZ\"";
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

SparseMatrixSize ParseSparseMatrix(
  std::istream& stream, SparseMatrixVisitor& visitor, const Monitor& monitor, std::size_t bufferSize)
{
  const SparseMatrixSize size = ReadSparseMatrixHeader(stream);
  LineBuffer lines(stream, bufferSize);
  ParseColumns(lines, size, visitor, monitor);
  return size;
}
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
SparseMatrixSummary ScanSparseMatrix(std::istream& stream, const Monitor& monitor, std::size_t bufferSize)
{
  CountingVisitor visitor;
  const SparseMatrixSize size = ParseSparseMatrix(stream, visitor, monitor, bufferSize);
  return { size, visitor.Counts(), visitor.VerticalFit() };
}

//----------------------------------------------------------------------------------------------------------------------
SparseMatrix LoadSparseMatrix(std::istream& stream, const SparseMatrixCounts& horizons, DuplicatePolicy policy,
  const Monitor& monitor, std::size_t bufferSize)
{
  LoadingVisitor visitor(horizons, policy);
  const SparseMatrixSize size = ParseSparseMatrix(stream, visitor, monitor, bufferSize);
  return { size, visitor.TakeHorizons() };
}
}
