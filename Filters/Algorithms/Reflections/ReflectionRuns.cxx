// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReflectionRuns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SeismicHorizons
{
namespace
{
/// The samples from First to before End have one sign.
struct Run
{
  int First = 0;
  int End = 0;
  float Sign = 1.0F;
  float Mean = 0.0F;
};

class TraceScan
{
public:
  TraceScan(const float* trace, int samples, const ReflectionRules& rules, std::vector<Reflection>& found)
    : Trace(trace)
    , Samples(samples)
    , Rules(rules)
    , Least(std::max(rules.SampleThreshold, std::numeric_limits<float>::denorm_min()))
    , Found(found)
  {
  }

  void Scan()
  {
    int sample = 0;
    while (sample < this->Samples)
    {
      const float value = this->Trace[sample];
      if (value >= this->Least)
      {
        sample = this->Take(sample, 1.0F);
      }
      else if (-value >= this->Least)
      {
        sample = this->Take(sample, -1.0F);
      }
      else
      {
        ++sample;
      }
    }
  }

private:
  /// Adds the picks of the run that begins at a sample, and gives its end.
  int Take(int first, float sign)
  {
    Run run{ first, first, sign, 0.0F };
    double sum = 0.0;
    while (run.End < this->Samples && sign * this->Trace[run.End] >= this->Least)
    {
      sum += this->Trace[run.End++];
    }
    const auto unwanted = sign > 0.0F ? ReflectionPolarity::Negative : ReflectionPolarity::Positive;
    if (this->Rules.Polarity != unwanted)
    {
      run.Mean = float(sum / (run.End - run.First));
      this->Rules.Position == ReflectionPosition::Middle ? this->AddMiddle(run) : this->AddPeaks(run);
    }
    return run.End;
  }

  void Add(const Run& run, Depth place, float strength)
  {
    this->Found.push_back({ place, run.End - run.First, run.Mean, strength });
  }

  void AddMiddle(const Run& run)
  {
    float strength = 0.0F;
    for (int sample = run.First; sample < run.End; ++sample)
    {
      strength = std::max(strength, run.Sign * this->Trace[sample]);
    }
    this->Add(run, (run.First + run.End - 1) * (DepthsPerSample / 2), strength);
  }

  /// A pick for each sample, or row of equal ones, that is larger than those before and behind it in the run.
  void AddPeaks(const Run& run)
  {
    bool isRising = true;
    for (int first = run.First; first < run.End;)
    {
      const float strength = run.Sign * this->Trace[first];
      int end = first + 1;
      while (end < run.End && this->Trace[end] == this->Trace[first])
      {
        ++end;
      }
      const bool rises = end < run.End && run.Sign * this->Trace[end] > strength;
      if (isRising && !rises)
      {
        const Depth middle = (first + end - 1) * (DepthsPerSample / 2);
        this->Add(run, end == first + 1 ? middle + this->VertexOffset(first) : middle, strength);
      }
      isRising = rises;
      first = end;
    }
  }

  /// How far the vertex of the parabola through three samples is from the middle one, which is the largest.
  Depth VertexOffset(int sample) const
  {
    if (sample == 0 || sample + 1 == this->Samples)
    {
      return 0;
    }
    const double before = this->Trace[sample - 1];
    const double behind = this->Trace[sample + 1];
    const double bend = before - 2.0 * this->Trace[sample] + behind;
    const double offset = 0.5 * (before - behind) / bend * DepthsPerSample;
    if (!std::isfinite(offset)) // beside a missing sample
    {
      return 0;
    }
    // Whatever rounding does, the sample stays the nearest one.
    constexpr double half = DepthsPerSample / 2;
    return Depth(std::clamp(std::floor(offset + 0.5), -half, half - 1.0));
  }

  const float* const Trace;
  const int Samples;
  const ReflectionRules& Rules;
  const float Least;
  std::vector<Reflection>& Found;
};
}

//----------------------------------------------------------------------------------------------------------------------
void FindReflections(const float* trace, int samples, const ReflectionRules& rules, std::vector<Reflection>& found)
{
  TraceScan(trace, samples, rules, found).Scan();
}
}
