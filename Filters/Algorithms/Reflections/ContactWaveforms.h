// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whether two parts look alike along their contact: by the means of the waveforms on both sides, in which noise cancels
// out.

#ifndef SeismicHorizonsContactWaveforms_h
#define SeismicHorizonsContactWaveforms_h

#include "SurfaceSets.h"
#include "TraceCube.h"
#include "Waveforms.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class ContactWaveforms
{
public:
  ContactWaveforms(const TraceCube& cube, const ReflectionPicks& picks, const SurfaceSets& sets, int halfWidth);

  /// The correlation, -1 to 1, of the mean waveform of the picks that the pairs come from with that of the picks they
  /// lead to: of about 64 of the pairs, spread over all of them.
  double Correlate(std::vector<Edge> pairs);

private:
  void AddWaveform(PointId pick, std::vector<std::int32_t>& sum);

  const TraceCube& Cube;
  const ReflectionPicks& Picks;
  const SurfaceSets& Sets;
  WaveformCutter Cutter;
  std::vector<float> Trace;
  std::vector<std::int16_t> Waveform;
};
}

#endif
