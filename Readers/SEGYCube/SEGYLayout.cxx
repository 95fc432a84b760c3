// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SEGYLayout.h"

#include "SEGYHeader.h"

#include <algorithm>
#include <cassert>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t TracesLookedAt = 8;
constexpr int MostOtherTexts = 16;

bool IsWhole(const SEGYExtents& file, const SEGYLayout& layout)
{
  const std::int64_t size = file.FileSize - file.FirstTrace(layout);
  return layout.Samples > 0 && size > 0 && size % file.TraceSize(layout) == 0;
}

/// Dead traces may state no samples.
bool IsRegular(const SEGYExtents& file, const SEGYLayout& layout)
{
  const std::int64_t traces = (file.FileSize - file.FirstTrace(layout)) / file.TraceSize(layout);
  int said = 0;
  for (std::int64_t n = 0; n < std::min(traces, TracesLookedAt) && layout.Samples > 0; ++n)
  {
    const std::int64_t trace = n < TracesLookedAt / 2 ? n : n * (traces - 1) / (std::min(traces, TracesLookedAt) - 1);
    const int samples = file.SamplesAt(file.FirstTrace(layout) + trace * file.TraceSize(layout));
    if (samples != 0 && said != 0 && samples != said)
    {
      return false;
    }
    said = samples != 0 ? samples : said;
  }
  return said > 0;
}

template <typename Test>
const SEGYLayout* FindShortest(const std::vector<SEGYLayout>& layouts, Test&& test)
{
  const SEGYLayout* found = nullptr;
  for (const SEGYLayout& layout : layouts)
  {
    found = test(layout) && (!found || layout.Samples < found->Samples) ? &layout : found;
  }
  return found;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t SEGYExtents::FirstTrace(const SEGYLayout& layout) const
{
  return SEGYFileHeaderSize + layout.Texts * std::int64_t(SEGYTextSize);
}

//----------------------------------------------------------------------------------------------------------------------
std::int64_t SEGYExtents::TraceSize(const SEGYLayout& layout) const
{
  return SEGYTraceHeaderSize + std::int64_t(layout.Samples) * std::int64_t(this->SampleSize);
}

//----------------------------------------------------------------------------------------------------------------------
SEGYLayout ChooseLayout(const SEGYExtents& file, const std::vector<SEGYLayout>& likely)
{
  assert(!likely.empty());
  const auto isWhole = [&](const SEGYLayout& layout) { return IsWhole(file, layout); };
  const auto isSound = [&](const SEGYLayout& layout) { return IsWhole(file, layout) && IsRegular(file, layout); };
  const auto isCut = [&](const SEGYLayout& layout)
  {
    const std::int64_t size = file.FileSize - file.FirstTrace(layout);
    return size >= 2 * file.TraceSize(layout) && IsRegular(file, layout);
  };
  if (const SEGYLayout* const found = FindShortest(likely, isSound))
  {
    return *found;
  }
  for (int texts = 1; texts <= MostOtherTexts; ++texts)
  {
    if (const SEGYLayout other = { texts, likely.front().Samples }; isSound(other))
    {
      return other;
    }
  }
  if (const SEGYLayout* const found = FindShortest(likely, isCut))
  {
    return *found;
  }
  const auto whole = std::find_if(likely.begin(), likely.end(), isWhole);
  return whole != likely.end() ? *whole : likely.front();
}
}
