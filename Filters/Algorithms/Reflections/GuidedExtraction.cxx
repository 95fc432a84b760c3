// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GuidedExtraction.h"

#include "Common/Base/Parallel.h"
#include "Common/Horizon/DataModel.h"
#include "GuideConfidence.h"
#include "SharedEvents.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace SeismicHorizons
{
namespace
{
// The half width of growth, in dominant periods, is short, to pass where layers thin out.
constexpr double GrowthWaveform = 1.5;

// Runs make the period some percent short, and on steep flanks growth needs the whole step.
constexpr double StepPerTruePeriod = 0.32;
constexpr double TolerancePerPeriod = 0.2;
constexpr double LeastTolerance = 1.5;
}

//----------------------------------------------------------------------------------------------------------------------
GuidedExtraction::GuidedExtraction(const std::vector<Guide>& guides, const CubeReflections& reflections, int samples,
  const ExtractionOptions& options, Extraction& result)
  : Options(options.Guidance)
  , Period(reflections.Period)
  , Step(std::max(result.LargestStep, options.LargestStep > 0.0 ? 0.0 : StepPerTruePeriod * reflections.Period))
  , Picks(guides.size())
  , Result(result)
{
  const double tolerance = this->Options.Tolerance > 0.0 ? this->Options.Tolerance
                                                         : std::max(LeastTolerance, TolerancePerPeriod * this->Period);
  for (std::size_t guide = 0; guide < guides.size(); ++guide)
  {
    std::array<std::vector<GuideSeed>, 2> seeds = FindGuideSeeds(
      guides[guide], reflections.BySign, samples, tolerance, this->Period / 4.0, result.Guides.emplace_back());
    for (const int sign : { 0, 1 })
    {
      if (!seeds[sign].empty())
      {
        this->Strands.push_back({ guide, sign, std::move(seeds[sign]), {} });
      }
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool GuidedExtraction::HasAny(int sign) const
{
  return std::any_of(
    this->Strands.begin(), this->Strands.end(), [sign](const Strand& strand) { return strand.Sign == sign; });
}

//----------------------------------------------------------------------------------------------------------------------
GrowthLinks GuidedExtraction::FindLinks(
  const TraceCube& cube, const ReflectionPicks& picks, const Monitor& monitor) const
{
  const LinkOptions link{ ColumnConnectivity::Eight, InDepths(this->Step), HalfWidth(GrowthWaveform, this->Period) };
  return { cube, picks, link, monitor };
}

//----------------------------------------------------------------------------------------------------------------------
void GuidedExtraction::Follow(const TraceCube& cube, int sign, const ReflectionPicks& picks,
  const SurfaceMembers& members, const GrowthLinks& links, RawVector<PointId>& surfaces,
  std::vector<FollowedGuide>& followed, const Monitor& monitor)
{
  std::vector<Strand*> strands;
  for (Strand& strand : this->Strands)
  {
    if (strand.Sign == sign)
    {
      strands.push_back(&strand);
    }
  }
  const GuidedJoining joining(
    cube, picks, surfaces, members, links, HalfWidth(LongWaveform, this->Period), this->Period, this->Options);
  ParallelFor(std::int64_t(strands.size()), 1, monitor,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        Strand& strand = *strands[n];
        const auto known = std::find_if(followed.begin(), followed.end(),
          [&strand](const FollowedGuide& guide) { return guide.Seeds == strand.Seeds; });
        if (known != followed.end())
        {
          strand.Surface = known->Surface;
          continue;
        }
        strand.Surface = joining.Follow(strand.Seeds);
        FindBlocks(picks, InDepths(this->Period / 4.0), strand.Surface);
      }
    });
  followed.clear();
  for (Strand* const strand : strands)
  {
    followed.push_back({ std::move(strand->Seeds), strand->Surface });
    GuideUse& use = this->Result.Guides[strand->Guide];
    use.Strays.insert(use.Strays.end(), strand->Surface.Strays.begin(), strand->Surface.Strays.end());
    std::sort(use.Strays.begin(), use.Strays.end());
    use.Doubtful += strand->Surface.Doubtful;
    use.Seams += strand->Surface.Seams;
    use.Stopped += strand->Surface.Stopped;
  }
  this->Share(strands, picks, links);
  for (const Strand* const strand : strands)
  {
    for (const GuidedPick& pick : strand->Surface.Picks)
    {
      surfaces[pick.Pick] = NoPoint;
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void GuidedExtraction::Share(
  const std::vector<Strand*>& strands, const ReflectionPicks& picks, const GrowthLinks& links)
{
  std::vector<GuidedSurface*> surfaces;
  std::vector<std::size_t> sizes;
  for (Strand* const strand : strands)
  {
    surfaces.push_back(&strand->Surface);
    sizes.push_back(strand->Surface.Picks.size());
  }
  for (const auto& [pair, count] : SettleSharedEvents(picks, links, surfaces))
  {
    this->NoteShared(strands[pair.first]->Guide, strands[pair.second]->Guide, count);
    this->NoteShared(strands[pair.second]->Guide, strands[pair.first]->Guide, count);
  }
  for (std::size_t n = 0; n < surfaces.size(); ++n)
  {
    if (surfaces[n]->Picks.size() != sizes[n])
    {
      FindBlocks(picks, InDepths(this->Period / 4.0), *surfaces[n]);
    }
  }
}

//----------------------------------------------------------------------------------------------------------------------
void GuidedExtraction::NoteShared(std::size_t guide, std::size_t other, std::int64_t count)
{
  GuideUse& use = this->Result.Guides[guide];
  if (count > use.Shared)
  {
    use.Shared = count;
    use.SharedWith = other;
  }
}

//----------------------------------------------------------------------------------------------------------------------
// Of the two in a column, the more confident one stays, or one nearer to its picks. Blocks of the second sign have
// numbers after those of the first.
void GuidedExtraction::JoinSigns(const CubeReflections& reflections)
{
  const auto trust = [](const GuidedPick& pick)
  {
    constexpr double doubtOfColumn = 0.01;
    constexpr int farthest = 30;
    return double(pick.Confidence) - doubtOfColumn * (pick.Distance < farthest ? pick.Distance : farthest);
  };
  std::vector<std::int32_t> blocks(this->Picks.size(), 0);
  for (Strand& strand : this->Strands)
  {
    std::vector<SignedPick>& picks = this->Picks[strand.Guide];
    const std::int32_t before = blocks[strand.Guide];
    for (GuidedPick& pick : strand.Surface.Picks)
    {
      pick.Block += before;
      blocks[strand.Guide] = std::max(blocks[strand.Guide], pick.Block);
      picks.push_back({ pick, strand.Sign, reflections.BySign[strand.Sign].ColumnOf(pick.Pick) });
    }
    std::stable_sort(picks.begin(), picks.end(),
      [&trust](const SignedPick& a, const SignedPick& b)
      { return a.Column != b.Column ? a.Column < b.Column : trust(a.Own) > trust(b.Own); });
    const auto isSame = [](const SignedPick& a, const SignedPick& b) { return a.Column == b.Column; };
    picks.erase(std::unique(picks.begin(), picks.end(), isSame), picks.end());
    strand.Surface = {};
  }
}

//----------------------------------------------------------------------------------------------------------------------
void GuidedExtraction::AddAttributes() const
{
  for (std::size_t n = 0; n < this->Picks.size(); ++n)
  {
    const auto gather = [&](auto values, auto value)
    {
      using Value = std::decay_t<decltype(values[0])>;
      for (const SignedPick& pick : this->Picks[n])
      {
        values.push_back(static_cast<Value>(pick.Own.*value));
      }
      return values;
    };
    LatticeHorizon& horizon = this->Result.Surfaces[n];
    horizon.Attributes.push_back({ PointArray::Confidence, gather(HeapArray<double>(), &GuidedPick::Confidence) });
    horizon.Attributes.push_back({ PointArray::Correlation, gather(HeapArray<double>(), &GuidedPick::Correlation) });
    horizon.Attributes.push_back({ PointArray::GuideDistance, gather(HeapArray<double>(), &GuidedPick::Distance) });
    horizon.Labels.push_back({ PointArray::Origin, gather(HeapArray<int>(), &GuidedPick::Origin) });
    horizon.Labels.push_back({ PointArray::Block, gather(HeapArray<int>(), &GuidedPick::Block) });
    horizon.Labels.push_back({ PointArray::Seed, gather(HeapArray<int>(), &GuidedPick::Seed) });
  }
}
}
