// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Follows guides, each on reflections of one sign, or of both where polarity turns.

#ifndef SeismicHorizonsGuidedExtraction_h
#define SeismicHorizonsGuidedExtraction_h

#include "Common/Base/Monitor.h"
#include "Common/Base/RawVector.h"
#include "GuideSeeds.h"
#include "GuidedJoining.h"
#include "ReflectionExtraction.h"
#include "ReflectionFinder.h"
#include "ReflectionLinks.h"
#include "TraceCube.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
class GuidedExtraction
{
public:
  /// `result` has the figures of the cube, and gets how guides are used.
  GuidedExtraction(const std::vector<Guide>& guides, const CubeReflections& reflections, int samples,
    const ExtractionOptions& options, Extraction& result);

  bool HasAny(int sign) const;

  GrowthLinks FindLinks(const TraceCube& cube, const ReflectionPicks& picks, const Monitor& monitor) const;

  /// Guides that have been followed with the same options are not followed again. Automatic surfaces lose the picks that
  /// guides keep.
  void Follow(const TraceCube& cube, int sign, const ReflectionPicks& picks, const SurfaceMembers& members,
    const GrowthLinks& links, RawVector<PointId>& surfaces, std::vector<FollowedGuide>& followed,
    const Monitor& monitor);

  /// Must come after all guides are followed; only the columns of picks need be known.
  void JoinSigns(const CubeReflections& reflections);

  /// Calls visit(guide, sign, pick).
  template <typename Visit>
  void ForEachPick(Visit&& visit) const
  {
    for (std::size_t guide = 0; guide < this->Picks.size(); ++guide)
    {
      for (const SignedPick& pick : this->Picks[guide])
      {
        visit(guide, pick.Sign, pick.Own.Pick);
      }
    }
  }

  std::size_t SizeOf(std::size_t guide) const { return this->Picks[guide].size(); }

  /// Surfaces must have their points.
  void AddAttributes() const;

private:
  /// What a guide has of one sign.
  struct Strand
  {
    std::size_t Guide = 0;
    int Sign = 0;
    std::vector<GuideSeed> Seeds;
    GuidedSurface Surface;
  };

  struct SignedPick
  {
    GuidedPick Own;
    int Sign = 0;
    std::int32_t Column = 0;
  };

  void Share(const std::vector<Strand*>& strands, const ReflectionPicks& picks, const GrowthLinks& links);
  void NoteShared(std::size_t guide, std::size_t other, std::int64_t count);

  const GuidanceOptions& Options;
  const double Period;
  const double Step; // largest, of growth, in samples
  std::vector<Strand> Strands;
  std::vector<std::vector<SignedPick>> Picks; // by guide, one per column, ascending
  Extraction& Result;
};
}

#endif
