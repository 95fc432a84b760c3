// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The edges that wait for a triangle to their left (the thesis's edge pool, 5.3.7).

#ifndef SeismicHorizonsAdvancingFront_h
#define SeismicHorizonsAdvancingFront_h

#include "Common/Types.h"

#include <vector>

namespace SeismicHorizons
{
/// A side that has something to its left, or an edge that waits for it.
struct FrontEdge
{
  PointId From = NoPoint;
  PointId To = NoPoint;
  /// Of the circle of the triangle on the side that is meshed; 0 where that is not known.
  float Diameter = 0.0f;
};

/// A set of edges from which the newest can be taken. Few of its edges begin in the same point, so each point has a
/// linked list of those that begin in it. 4 bytes per point, and 24 per edge.
class AdvancingFront
{
public:
  /// For edges that begin in the points from `first` to before `end`.
  AdvancingFront(PointId first, PointId end)
    : FirstPoint(first)
    , First(std::size_t(end - first), None)
  {
  }

  void Add(const FrontEdge& edge)
  {
    std::int32_t& first = this->FirstLink(edge.From);
    const std::int32_t link = this->NewLink();
    this->Links[std::size_t(link)] = { edge.To, first };
    first = link;
    this->Newest.push_back(edge);
  }

  /// Removes an edge; false when it is not in the front.
  bool Remove(PointId from, PointId to)
  {
    std::int32_t* link = &this->FirstLink(from);
    while (*link != None && this->Links[std::size_t(*link)].To != to)
    {
      link = &this->Links[std::size_t(*link)].Next;
    }
    if (*link == None)
    {
      return false;
    }
    this->Free.push_back(*link);
    *link = this->Links[std::size_t(*link)].Next;
    return true;
  }

  /// Adds a side that has something to its left now: if it waited for that it leaves the front, else its reverse waits
  /// for a triangle.
  void AddSide(const FrontEdge& side)
  {
    if (!this->Remove(side.From, side.To))
    {
      this->Add({ side.To, side.From, side.Diameter });
    }
  }

  /// Removes the edge that was added last; false when the front is empty.
  bool TakeNewest(FrontEdge& edge)
  {
    while (!this->Newest.empty())
    {
      edge = this->Newest.back();
      this->Newest.pop_back();
      // Edges that were removed in the meantime are still in this list.
      if (this->Remove(edge.From, edge.To))
      {
        return true;
      }
    }
    return false;
  }

private:
  static constexpr std::int32_t None = -1;

  struct Link
  {
    PointId To;
    std::int32_t Next;
  };

  std::int32_t& FirstLink(PointId from) { return this->First[std::size_t(from - this->FirstPoint)]; }

  std::int32_t NewLink()
  {
    if (this->Free.empty())
    {
      this->Links.emplace_back();
      return std::int32_t(this->Links.size() - 1);
    }
    const std::int32_t link = this->Free.back();
    this->Free.pop_back();
    return link;
  }

  const PointId FirstPoint;
  std::vector<std::int32_t> First; // for each point the first link of its list
  std::vector<Link> Links;
  std::vector<std::int32_t> Free; // links that are in no list
  std::vector<FrontEdge> Newest; // in the order in which they were added
};
}

#endif
