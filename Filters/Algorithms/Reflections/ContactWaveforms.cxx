// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ContactWaveforms.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
ContactWaveforms::ContactWaveforms(
  const TraceCube& cube, const ReflectionPicks& picks, const SurfaceSets& sets, int halfWidth)
  : Cube(cube)
  , Picks(picks)
  , Sets(sets)
  , Cutter(halfWidth)
  , Trace(std::size_t(cube.Size[2]))
  , Waveform(std::size_t(this->Cutter.Width()))
{
}

//----------------------------------------------------------------------------------------------------------------------
double ContactWaveforms::Correlate(std::vector<Edge> pairs)
{
  constexpr std::size_t enough = 64;
  std::sort(pairs.begin(), pairs.end(),
    [](const Edge& a, const Edge& b) { return std::tie(a.From, a.To) < std::tie(b.From, b.To); });
  std::vector<std::int32_t> from(this->Waveform.size(), 0);
  std::vector<std::int32_t> to(this->Waveform.size(), 0);
  const std::size_t step = std::max<std::size_t>(1, pairs.size() / enough);
  for (std::size_t n = 0; n < pairs.size(); n += step)
  {
    this->AddWaveform(pairs[n].From, from);
    this->AddWaveform(pairs[n].To, to);
  }
  // Sums of whole numbers: the same in any order.
  const auto product = [](const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b)
  {
    return double(std::inner_product(a.begin(), a.end(), b.begin(), std::int64_t(0), std::plus<>(),
      [](std::int64_t x, std::int64_t y) { return x * y; }));
  };
  const double norm = std::sqrt(product(from, from) * product(to, to));
  return norm > 0.0 ? product(from, to) / norm : 0.0;
}

//----------------------------------------------------------------------------------------------------------------------
void ContactWaveforms::AddWaveform(PointId pick, std::vector<std::int32_t>& sum)
{
  const std::int32_t column = this->Sets.ColumnOf(pick);
  this->Cube.Read(column / this->Picks.Columns[0], column % this->Picks.Columns[0], 1, this->Trace.data());
  this->Cutter.SetTrace(this->Trace.data(), this->Cube.Size[2]);
  this->Cutter.CutOut(this->Picks.PlaceOf(pick), this->Waveform.data());
  std::transform(sum.begin(), sum.end(), this->Waveform.begin(), sum.begin(), std::plus<>());
}
}
