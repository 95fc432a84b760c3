// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the traces of a SEG-Y file begin, and how long they are. Headers are wrong in many files; the traces tell.

#ifndef SeismicHorizonsSEGYLayout_h
#define SeismicHorizonsSEGYLayout_h

#include "SEGYSamples.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace SeismicHorizons
{
struct SEGYLayout
{
  int Texts = 0; // behind the binary header
  int Samples = 0; // of a trace
};

/// What is known of a file, whatever its layout.
struct SEGYExtents
{
  std::int64_t FileSize = 0;
  std::size_t SampleSize = 0;
  /// The number of samples in the header of a trace (byte 115) that begins at a byte; -1 behind the end of the file.
  std::function<int(std::int64_t)> SamplesAt;

  std::int64_t FirstTrace(const SEGYLayout& layout) const;
  std::int64_t TraceSize(const SEGYLayout& layout) const;
};

/// The layout with the shortest traces of those that fill the file with whole traces which all say the same number of
/// samples, whatever it is: with a multiple of the true length every second trace, say, would be found. Where none of
/// the likely ones does, the first of others that does so, else a likely one whose traces say the same but for the end
/// of the file, else the first that fills the file, else the first.
SEGYLayout ChooseLayout(
  const SEGYExtents& file, const std::vector<SEGYLayout>& likely, const std::vector<SEGYLayout>& others);
}

#endif
