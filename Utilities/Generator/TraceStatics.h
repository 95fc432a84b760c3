// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How late each trace of a synthetic cube is. Each line of receivers is late by a little more or less than the one
// before, and so is each line of sources; so are all traces of some patches, and each one by itself.

#ifndef SeismicHorizonsTraceStatics_h
#define SeismicHorizonsTraceStatics_h

#include "CubeGeneratorOptions.h"
#include "CubeRandom.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class TraceStatics
{
public:
  explicit TraceStatics(const CubeGeneratorOptions& options)
    : Given(options)
  {
    for (const std::size_t axis : { 0U, 1U })
    {
      double late = 0.0;
      for (int line = 0; line < options.Size[axis]; ++line)
      {
        late = 0.9 * late + 0.08 * this->Either(ShiftOfLine, std::int64_t(axis), line);
        this->Lines[axis].push_back(late);
      }
    }
  }

  /// In samples, 0 without the trouble.
  double At(int i, int j) const
  {
    if (!this->Given.Has(Trouble::Statics))
    {
      return 0.0;
    }
    double late =
      this->Lines[0][std::size_t(i)] + this->Lines[1][std::size_t(j)] + 0.1 * this->Either(ShiftOfTrace, i, j);
    for (int patch = 0; patch < 3; ++patch)
    {
      late +=
        this->IsWithin(patch, 0, i) && this->IsWithin(patch, 1, j) ? 0.25 * this->Either(ShiftOfPatch, patch, 2) : 0.0;
    }
    return late * 1000.0 / (this->Given.Frequency * this->Given.SampleInterval);
  }

private:
  double Either(Purpose purpose, std::int64_t what, std::int64_t which) const
  {
    return 2.0 * RandomOf(this->Given.Seed, purpose, what, which) - 1.0;
  }

  bool IsWithin(int patch, std::size_t axis, int place) const
  {
    const double middle = RandomOf(this->Given.Seed, ShiftOfPatch, patch, std::int64_t(axis));
    return std::abs(place - middle * this->Given.Size[axis]) < 0.2 * this->Given.Size[axis];
  }

  CubeGeneratorOptions Given;
  std::array<std::vector<double>, 2> Lines; // in periods
};
}

#endif
