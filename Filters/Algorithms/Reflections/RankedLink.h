// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Links as numbers that sort them by rank.

#ifndef SeismicHorizonsRankedLink_h
#define SeismicHorizonsRankedLink_h

#include "Common/CountingSort.h"
#include "ReflectionLinks.h"

#include <cstdint>
#include <vector>

namespace SeismicHorizons
{
/// Where a link leads, as a window of columns sees it.
enum class Lead
{
  Within, // both picks are in the window
  Out, // only the first one
  In // only the second one
};

/// The rank, the link, and where it leads, from the upper bits down.
class RankedLink
{
public:
  RankedLink() = default;
  RankedLink(std::int64_t rank, LinkId link, Lead lead)
    : Bits(std::uint64_t(rank) << RankShift | std::uint64_t(link) << LeadBits | std::uint64_t(lead))
  {
  }

  LinkId Link() const { return LinkId(this->Bits >> LeadBits); }
  Lead Leads() const { return Lead(this->Bits & LeadMask); }
  void SetLead(Lead lead) { this->Bits = (this->Bits & ~LeadMask) | std::uint64_t(lead); }

  friend bool operator<(const RankedLink& a, const RankedLink& b) { return a.Bits < b.Bits; }

  /// Sorts by rank, and keeps the order of links of the same rank.
  static void SortByRank(std::vector<RankedLink>& links)
  {
    constexpr int digit = 8; // bits; a rank has two of them
    std::vector<RankedLink> sorted(links.size());
    for (const int shift : { RankShift, RankShift + digit })
    {
      const auto keyOf = [shift](const RankedLink& link)
      { return std::int64_t(link.Bits >> shift & ((1U << digit) - 1)); };
      SmallCountingSort<std::uint32_t, std::size_t(1) << digit> sort;
      for (const RankedLink& link : links)
      {
        sort.Count(keyOf(link));
      }
      sort.EndCounting();
      for (const RankedLink& link : links)
      {
        sorted[sort.NextPosition(keyOf(link))] = link;
      }
      links.swap(sorted);
    }
  }

private:
  static constexpr int LeadBits = 2;
  static constexpr std::uint64_t LeadMask = (1U << LeadBits) - 1;
  static constexpr int RankShift = LeadBits + 32;

  std::uint64_t Bits = 0;
};
}

#endif
