// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the first trace and the length of traces, from the traces themselves, as headers are often wrong.
//
// ChooseLayout prefers the shortest traces that fill the file exactly and state the same number of samples, whatever it
// is; with a multiple of the true length only every second trace, say, would be found. Next best are, in order: the
// first such layout with extended texts that the header does not state, a likely layout that is consistent except at
// the end of the file, the first that fills the file, and the first.

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
  int Texts = 0; // after the binary header
  int Samples = 0; // per trace
};

struct SEGYExtents
{
  std::int64_t FileSize = 0;
  std::size_t SampleSize = 0;
  /// Returns byte 115 of the trace header at an offset, or -1 after the end of the file.
  std::function<int(std::int64_t)> SamplesAt;

  std::int64_t FirstTrace(const SEGYLayout& layout) const;
  std::int64_t TraceSize(const SEGYLayout& layout) const;
};

/// `likely` are in order of preference, and not empty.
SEGYLayout ChooseLayout(const SEGYExtents& file, const std::vector<SEGYLayout>& likely);
}

#endif
