// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How generated voxels become text: the same digits on every machine.

#ifndef SeismicHorizonsVoxelText_h
#define SeismicHorizonsVoxelText_h

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace SeismicHorizons
{
constexpr double TimePerSample = 4.0; // ms, two-way

inline double Round(double value, double stepsPerUnit)
{
  return std::floor(value * stepsPerUnit + 0.5) / stepsPerUnit;
}

/// Appends a number to a line. What else there is says how std::to_chars writes it.
template <typename Number, typename... Format>
void AppendNumber(std::string& line, Number number, Format... format)
{
  std::array<char, 64> digits;
  const std::to_chars_result result = std::to_chars(digits.data(), digits.data() + digits.size(), number, format...);
  line += line.empty() ? "" : " ";
  line.append(digits.data(), static_cast<std::size_t>(result.ptr - digits.data()));
}

inline void AppendVoxel(std::string& line, const SparseMatrixVoxel& voxel)
{
  AppendNumber(line, voxel.VerticalIndex);
  AppendNumber(line, voxel.SurfaceId);
  AppendNumber(line, voxel.Thickness, std::chars_format::fixed);
  AppendNumber(line, voxel.Amplitude, std::chars_format::fixed);
  AppendNumber(line, voxel.RealZ, std::chars_format::fixed);
}

inline void WriteHeader(const SparseMatrixSize& size, std::ostream& stream)
{
  stream << std::to_string(size[0]) + ' ' + std::to_string(size[1]) + ' ' + std::to_string(size[2]) + '\n';
}

/// Writes the lines of columns, and empties them.
inline void WriteLines(std::vector<std::string>& columns, std::ostream& stream)
{
  for (std::string& column : columns)
  {
    column += '\n';
    stream.write(column.data(), static_cast<std::streamsize>(column.size()));
    column.clear();
  }
}

/// Throws std::runtime_error when the stream has not taken everything.
inline void FinishFile(std::ostream& stream)
{
  if (!stream.flush())
  {
    throw std::runtime_error("writing failed");
  }
}
}

#endif
