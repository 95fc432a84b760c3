// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What tests of the parser of sparse-matrix files share: a small file, and buffers that cut it everywhere.

#ifndef SeismicHorizonsParserFixtures_h
#define SeismicHorizonsParserFixtures_h

#include "Readers/VerneySparseMatrix/SparseMatrixParser.h"

#include <array>
#include <cstddef>
#include <sstream>
#include <string>

namespace ParserFixtures
{
using namespace SeismicHorizons;

// All kinds of buffers, so that every token is cut by the end of one somewhere.
constexpr std::array<std::size_t, 6> BufferSizes = { 1, 2, 3, 7, 64, 4096 };

// 3 x 2 x 10 cells, horizons 4 and -7. Column (1, 0) has both, (2, 0) none, the last one has horizon 4.
inline const std::string Small = "3 2 10\n"
                                 "5 4 1.5 -20 21.25\n"
                                 "2 -7 1 1e2 8 6 4 2 -0.5 24\n"
                                 "\n"
                                 "\n"
                                 "9 -7 1 7 36\n"
                                 "0 4 1 3 0.125\n";

inline SparseMatrix Load(
  const std::string& text, DuplicatePolicy policy = DuplicatePolicy::StrongestAmplitude, std::size_t bufferSize = 4096)
{
  std::istringstream stream(text);
  return ReadSparseMatrix(stream, { policy }, Monitor(), bufferSize);
}
}

#endif
