// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MeshGroups.h"

#include "Common/Base/HeapArray.h"
#include "Common/Base/Parallel.h"
#include "Common/Horizon/PlaneGeometry.h"
#include "GroupHeights.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace SeismicHorizons
{
namespace
{
using GroupSteps = std::vector<GroupStep>;

const GroupSteps CollapseSteps = { GroupStep::Collapse };
const GroupSteps RoundSteps = { GroupStep::Collapse, GroupStep::Flip, GroupStep::Move, GroupStep::Collapse };
const GroupSteps SquareSteps = { GroupStep::FitSquares };
const GroupSteps CostSteps = { GroupStep::FindCosts };
const GroupSteps ChoiceSteps = { GroupStep::CollapseChosen, GroupStep::FindCosts };
const GroupSteps SmoothSteps = { GroupStep::Flip, GroupStep::Move, GroupStep::Flip, GroupStep::Move };

// Fractions of a group, so that edges between groups are not between the next ones.
constexpr std::array<double, 4> ShiftsOfGroups = { 0.0, 0.5, 0.25, 0.75 };

// ---- Numbers of vertices -------------------------------------------------------------------------------------------
// The sum of squares may fall where the largest error grows.
constexpr double FirstBound = 3.0;
// A pass removes this fraction of the vertices at most, so that the cheaper of two neighbours goes first.
constexpr double FractionOfPass = 0.5;
constexpr double FractionForWhole = 0.01;
// A mesh smoothed half-way, at this multiple of the final inner vertices, shows better which can go.
constexpr double HalfWay = 1.5;
// As many passes without a removal, with all shifts, mean that none is possible.
constexpr int MostIdlePasses = 4;
// After this number of halvings, any angle will do.
constexpr int MostHalvings = 12;

// ---- Largest errors ------------------------------------------------------------------------------------------------
// The number falls about as the error to this power; much less where a mesh within less is improved again.
constexpr double NumberPower = 2.0;
constexpr double LeastPower = 0.1;
constexpr double MostPower = 4.0;
constexpr double AimOfSearch = 0.99;
constexpr double EnoughOfNumber = 0.98;
constexpr double EnoughOfError = 0.97;
constexpr double NearEnough = 1.01;
constexpr double Away = 1.003; // of errors that were tried
constexpr int MostTrials = 12;
// A mesh is improved to the end only if so much of the number is expected.
constexpr double LeastExpected = 0.97;
constexpr double MostExpected = 1.02;
// What the first collapses leave of the vertices, to this power, is what the rest leaves of those.
constexpr double PowerOfRest = 0.245;
// Steps that lead to too many vertices again may be larger, by the square: whole heights need as many vertices for any
// error below a half.
constexpr double FarthestStep = 2.0;

// Large enough that few edges lie between groups, small enough for many threads.
constexpr double TrianglesOfGroup = 1500.0;
// This number of columns takes as long as a triangle.
constexpr double ColumnsPerTriangle = 32.0;

/// Numbers the vertices of some triangles in ascending order. A bit per vertex is faster than to sort and to search.
class VertexNumbers
{
public:
  explicit VertexNumbers(const std::vector<std::array<VertexId, 3>>& triangles)
  {
    VertexId last = triangles.front()[0];
    this->First = last;
    ForEachCorner(triangles,
      [&](VertexId vertex)
      {
        this->First = std::min(this->First, vertex);
        last = std::max(last, vertex);
      });
    this->Words.resize(std::size_t(last - this->First) / BitsOfWord + 1);
    ForEachCorner(triangles, [this](VertexId vertex) { this->WordOf(vertex).Bits.set(this->BitOf(vertex)); });
    for (std::size_t n = 1; n < this->Words.size(); ++n)
    {
      this->Words[n].Before = this->Words[n - 1].Before + VertexId(this->Words[n - 1].Bits.count());
    }
  }

  std::vector<VertexId> Vertices() const
  {
    std::vector<VertexId> vertices;
    for (std::size_t word = 0; word < this->Words.size(); ++word)
    {
      const std::bitset<BitsOfWord>& bits = this->Words[word].Bits;
      for (std::size_t bit = 0; bit < BitsOfWord && bits.any(); ++bit)
      {
        if (bits[bit])
        {
          vertices.push_back(this->First + VertexId(BitsOfWord * word + bit));
        }
      }
    }
    return vertices;
  }

  VertexId operator[](VertexId vertex) const
  {
    const Word& word = this->Words[std::size_t(vertex - this->First) / BitsOfWord];
    return word.Before + VertexId((word.Bits << (BitsOfWord - 1 - this->BitOf(vertex))).count()) - 1;
  }

private:
  static constexpr std::size_t BitsOfWord = 64;

  struct Word
  {
    std::bitset<BitsOfWord> Bits;
    VertexId Before = 0;
  };

  template <typename Visitor>
  static void ForEachCorner(const std::vector<std::array<VertexId, 3>>& triangles, Visitor&& visit)
  {
    for (const auto& corners : triangles)
    {
      std::for_each(corners.begin(), corners.end(), visit);
    }
  }

  Word& WordOf(VertexId vertex) { return this->Words[std::size_t(vertex - this->First) / BitsOfWord]; }
  std::size_t BitOf(VertexId vertex) const { return std::size_t(vertex - this->First) % BitsOfWord; }

  VertexId First;
  std::vector<Word> Words;
};

class MeshGroups
{
public:
  MeshGroups(HeightMesh& mesh, const DecimationOptions& options, const ColumnRule& rule)
    : Mesh(&mesh)
    , Rule(&rule)
    , Crossings(options.Crossings)
    , Vertices(std::size_t(mesh.EndOfVertices()))
  {
    this->Options.SmallestAngle = options.SmallestAngle;
    this->Options.FitHeights = options.FitHeights;
    this->TakeMesh();
  }

  void SetError(double error, int power = 4)
  {
    this->Options.Error = error;
    this->Options.CrossingError = MaximumCrossingError(error, this->Crossings);
    this->Options.Power = power;
    for (GroupVertex& vertex : this->Vertices)
    {
      vertex.Marks = TryAll;
    }
  }

  /// Returns about as many vertices as ImproveRest() will leave.
  double CollapseWithinError(const Monitor& monitor)
  {
    const double before = double(CountInner(this->Vertices));
    this->RunPass(CollapseSteps, 1, monitor);
    const double inner = double(CountInner(this->Vertices));
    return double(this->CountVertices()) - inner + inner * std::pow(inner / std::max(before, 1.0), PowerOfRest);
  }

  void ImproveRest(const Monitor& monitor)
  {
    constexpr int rounds = 2;
    this->RunPass(RoundSteps, rounds, monitor.Step(0.0, 0.5));
    this->RunPass(RoundSteps, rounds, monitor.Step(0.5, 0.85));
    this->RunPass(SquareSteps, 1, monitor.Step(0.85, 1.0));
  }

  std::size_t CountVertices() const
  {
    return std::size_t(std::count_if(
      this->Vertices.begin(), this->Vertices.end(), [](const GroupVertex& vertex) { return !vertex.IsGone; }));
  }

  /// The cheapest vertices go, until so many are left or none can go.
  void ReduceTo(std::size_t number, const Monitor& monitor)
  {
    const std::size_t first = this->CountVertices();
    const std::size_t fixed = first - CountInner(this->Vertices);
    std::size_t aim = fixed + std::size_t(HalfWay * double(number - std::min(number, fixed)));
    this->RunPass(SmoothSteps, 1, monitor.Step(0.0, 0.1));
    this->RunPass(CostSteps, 1, monitor.Step(0.1, 0.2));
    int halvings = 0;
    int idle = 0;
    for (std::size_t left = first; left > number && halvings <= MostHalvings;)
    {
      if (left <= aim)
      {
        aim = number;
        this->RunPass(SmoothSteps, 1, Monitor());
        this->RunPass(CostSteps, 1, Monitor());
      }
      // The last ones are not kept back by edges between groups.
      this->AreWhole = double(left - aim) < FractionForWhole * double(left);
      this->Choose(left - aim);
      this->RunPass(ChoiceSteps, 1, Monitor());
      const std::size_t before = left;
      left = this->CountVertices();
      monitor.Progress(0.2 + 0.7 * double(first - left) / double(first - number));
      idle = left < before ? 0 : idle + 1;
      if (idle == MostIdlePasses)
      {
        idle = 0;
        this->Relax(++halvings);
      }
    }
    this->AreWhole = false;
    this->Smooth(monitor.Step(0.9, 1.0));
  }

  void Smooth(const Monitor& monitor)
  {
    constexpr int rounds = 2;
    this->RunPass(SmoothSteps, rounds, monitor.Step(0.0, 0.5));
    this->RunPass(SmoothSteps, rounds, monitor.Step(0.5, 1.0));
  }

  void GiveBack()
  {
    RawVector<VertexId> triangles;
    for (const Triangles& patch : this->Patches)
    {
      for (const Corners& corners : patch)
      {
        triangles.insert(triangles.end(), corners.begin(), corners.end());
      }
    }
    std::vector<PointId> sources(this->Vertices.size(), NoPoint);
    for (std::size_t vertex = 0; vertex < sources.size(); ++vertex)
    {
      const GroupVertex& own = this->Vertices[vertex];
      sources[vertex] = own.IsGone ? NoPoint : this->Mesh->RasterAt(0, VertexId(vertex)).PointAt(this->Places[vertex]);
    }
    this->Mesh->Replace(std::move(sources), this->Heights, triangles);
  }

private:
  using Corners = std::array<VertexId, 3>;
  using Triangles = std::vector<Corners>;

  /// Vertices without a triangle have no group and stay.
  void TakeMesh()
  {
    const PlaneMesh& plane = this->Mesh->Triangles();
    for (VertexId vertex = 0; vertex < this->Mesh->EndOfVertices(); ++vertex)
    {
      this->Places.push_back(this->Mesh->Raised(vertex).Column);
      this->Vertices[vertex].IsFixed = this->Mesh->IsFixed(vertex);
      this->Vertices[vertex].IsGone = this->Mesh->IsRemoved(vertex);
    }
    this->Heights.resize(this->Mesh->NumberOfHorizons());
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      for (VertexId vertex = 0; vertex < this->Mesh->EndOfVertices(); ++vertex)
      {
        this->Heights[horizon].push_back(this->Mesh->Height(horizon, vertex));
      }
    }
    this->Patches.resize(this->Mesh->NumberOfPatches());
    for (TriangleId triangle = 0; triangle < plane.Size(); ++triangle)
    {
      this->Patches[this->Mesh->PatchOf(plane.Corner(triangle, 0))].push_back(plane.Corners(triangle));
      for (int edge = 0; edge < 3; ++edge)
      {
        if (plane.IsKeptEdge(triangle, edge)) // its ends may lie on a longer kept line
        {
          this->Vertices[plane.Corner(triangle, edge)].IsFixed = true;
          this->Vertices[plane.Corner(triangle, NextCorner(edge))].IsFixed = true;
        }
      }
    }
  }

  void Choose(std::size_t most)
  {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t vertex = 0; vertex < this->Vertices.size(); ++vertex)
    {
      GroupVertex& own = this->Vertices[vertex];
      own.IsChosen = false;
      const bool isKnown = (own.Marks & TryCollapse) == 0; // not between groups of the last pass
      if (own.IsInner() && isKnown && own.Cost < StarTrial::Never)
      {
        order.emplace_back(own.Cost, vertex);
      }
    }
    const std::size_t part = std::min(most, std::size_t(std::ceil(FractionOfPass * double(order.size()))));
    std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(part), order.end());
    for (std::size_t n = 0; n < part; ++n)
    {
      this->Vertices[order[n].second].IsChosen = true;
      this->Options.MostCost = order[n].first;
    }
  }

  /// Allows for larger errors, smaller angles and more triangles around a vertex.
  void Relax(int halvings)
  {
    this->Options.MostTriangles *= 2;
    this->Options.SmallestAngle = halvings < MostHalvings ? 0.5 * this->Options.SmallestAngle : 0.0;
    this->SetError(2.0 * this->Options.Error, this->Options.Power);
    this->RunPass(CostSteps, 1, Monitor());
  }

  void RunPass(const GroupSteps& steps, int mostRounds, const Monitor& monitor)
  {
    const double shift = ShiftsOfGroups[std::size_t(this->Passes++) % ShiftsOfGroups.size()];
    std::vector<Triangles> groups;
    std::vector<std::size_t> patchOf;
    for (std::size_t patch = 0; patch < this->Patches.size(); ++patch)
    {
      std::vector<Triangles> own = this->MakeGroups(this->Patches[patch], shift);
      std::move(own.begin(), own.end(), std::back_inserter(groups));
      patchOf.resize(groups.size(), patch);
      this->Patches[patch].clear();
    }
    std::vector<std::vector<VertexId>> between(groups.size());
    ParallelFor(std::int64_t(groups.size()), 1, monitor,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          this->Improve(groups[std::size_t(n)], steps, mostRounds, between[std::size_t(n)]);
        }
      });
    for (std::size_t n = 0; n < groups.size(); ++n)
    {
      Triangles& patch = this->Patches[patchOf[n]];
      patch.insert(patch.end(), groups[n].begin(), groups[n].end());
    }
    for (const std::vector<VertexId>& vertices : between)
    {
      std::for_each(
        vertices.begin(), vertices.end(), [this](VertexId vertex) { this->Vertices[vertex].Marks = TryAll; });
    }
  }

  // ---- Groups ------------------------------------------------------------------------------------------------------
  /// Strips of equal work along x, which are cut along y.
  std::vector<Triangles> MakeGroups(const Triangles& triangles, double shift) const
  {
    PlaneBox box;
    double work = 0.0;
    for (const Corners& corners : triangles)
    {
      box.Add(this->Places[corners[0]]);
      work += this->WorkOf(corners);
    }
    const double number = work / TrianglesOfGroup;
    if (number < 1.5 || this->AreWhole)
    {
      return triangles.empty() ? std::vector<Triangles>() : std::vector<Triangles>{ triangles };
    }
    const double width = double(box.Greatest.X) - box.Least.X + 1.0;
    const double height = double(box.Greatest.Y) - box.Least.Y + 1.0;
    const double strips = std::max(1.0, std::round(std::sqrt(number * width / height)));
    const std::vector<Triangles> cut =
      this->Cut(triangles, strips, shift, [](const PlanePoint& place) { return place.X; });
    std::vector<std::vector<Triangles>> groups(cut.size());
    ParallelFor(std::int64_t(cut.size()), 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (auto strip = std::size_t(first); strip < std::size_t(last); ++strip)
        {
          groups[strip] = this->Cut(cut[strip], std::max(1.0, std::round(number / strips)), shift,
            [](const PlanePoint& place) { return place.Y; });
        }
      });
    std::vector<Triangles> all;
    for (std::vector<Triangles>& strip : groups)
    {
      std::move(strip.begin(), strip.end(), std::back_inserter(all));
    }
    return all;
  }

  double WorkOf(const Corners& corners) const
  {
    const double columns =
      0.5 * double(SignedArea(this->Places[corners[0]], this->Places[corners[1]], this->Places[corners[2]]));
    return 1.0 + columns / ColumnsPerTriangle;
  }

  template <typename Coordinate>
  std::vector<Triangles> Cut(const Triangles& triangles, double parts, double shift, Coordinate&& coordinate) const
  {
    const auto sumOf = [&](const Corners& corners)
    {
      return std::int64_t(coordinate(this->Places[corners[0]])) + coordinate(this->Places[corners[1]]) +
        coordinate(this->Places[corners[2]]);
    };
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::int64_t greatest = std::numeric_limits<std::int64_t>::min();
    for (const Corners& corners : triangles)
    {
      least = std::min(least, sumOf(corners));
      greatest = std::max(greatest, sumOf(corners));
    }
    std::vector<double> before(std::size_t(greatest - least) + 2, 0.0); // work of smaller sums
    for (const Corners& corners : triangles)
    {
      before[std::size_t(sumOf(corners) - least) + 1] += this->WorkOf(corners);
    }
    std::partial_sum(before.begin(), before.end(), before.begin());
    std::vector<Triangles> cut(std::size_t(parts) + 1);
    for (const Corners& corners : triangles)
    {
      const double part = before[std::size_t(sumOf(corners) - least)] / before.back();
      cut[std::size_t(std::min(part * parts + shift, parts))].push_back(corners);
    }
    cut.erase(std::remove_if(cut.begin(), cut.end(), [](const Triangles& one) { return one.empty(); }), cut.end());
    return cut;
  }

  /// Vertices between groups are in several, and remain as they are; each of the others is in one alone.
  void Improve(Triangles& triangles, const GroupSteps& steps, int mostRounds, std::vector<VertexId>& between)
  {
    Group group;
    const VertexNumbers numbers(triangles);
    const std::vector<VertexId> vertices = numbers.Vertices();
    RawVector<VertexId> corners;
    corners.reserve(3 * triangles.size());
    for (const Corners& own : triangles)
    {
      std::for_each(own.begin(), own.end(), [&](VertexId vertex) { corners.push_back(numbers[vertex]); });
    }
    this->Fill(group, vertices, corners);
    ImproveGroup(group, this->Options, steps, mostRounds);
    this->Take(group, vertices, between);
    triangles.clear();
    for (TriangleId triangle = 0; triangle < group.Mesh.Size(); ++triangle)
    {
      const Corners& own = group.Mesh.Corners(triangle);
      triangles.push_back({ vertices[own[0]], vertices[own[1]], vertices[own[2]] });
    }
  }

  void Fill(Group& group, const std::vector<VertexId>& vertices, const RawVector<VertexId>& corners) const
  {
    PlaneBox box;
    std::for_each(vertices.begin(), vertices.end(), [&](VertexId vertex) { box.Add(this->Places[vertex]); });
    group.Box = box;
    std::vector<PlanePoint> places;
    for (const VertexId vertex : vertices)
    {
      const PlanePoint& place = this->Places[vertex];
      places.push_back({ place.X - box.Least.X, place.Y - box.Least.Y });
      group.Vertices.push_back(this->Vertices[vertex]);
    }
    group.Mesh = PlaneMesh(std::move(places), corners);
    for (TriangleId triangle = 0; triangle < group.Mesh.Size(); ++triangle)
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const VertexId from = group.Mesh.Corner(triangle, edge);
        const VertexId to = group.Mesh.Corner(triangle, NextCorner(edge));
        if (this->Mesh->Triangles().IsKept(vertices[from], vertices[to]))
        {
          group.Mesh.Keep(from, to);
        }
      }
    }
    group.Cuts = this->Mesh->Cuts();
    group.Rule = *this->Rule;
    group.Horizons.resize(this->Heights.size());
    for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
    {
      Group::Horizon& own = group.Horizons[horizon];
      own.Heights = Gather<std::vector<double>>(this->Heights[horizon], vertices);
      own.Raster = &this->Mesh->RasterAt(horizon, vertices.front());
    }
  }

  void Take(const Group& group, const std::vector<VertexId>& vertices, std::vector<VertexId>& between)
  {
    for (std::size_t n = 0; n < vertices.size(); ++n)
    {
      const VertexId vertex = vertices[n];
      if (group.Vertices[n].IsFixed)
      {
        between.push_back(vertex);
        continue;
      }
      for (std::size_t horizon = 0; horizon < this->Heights.size(); ++horizon)
      {
        this->Heights[horizon][vertex] = group.Horizons[horizon].Heights[n];
      }
      const PlanePoint& place = group.Mesh.Place(VertexId(n));
      this->Places[vertex] = { place.X + group.Box.Least.X, place.Y + group.Box.Least.Y };
      this->Vertices[vertex] = group.Vertices[n];
    }
  }

  HeightMesh* Mesh;
  const ColumnRule* Rule;
  CrossingTolerance Crossings;
  GroupOptions Options;
  std::vector<PlanePoint> Places;
  std::vector<GroupVertex> Vertices;
  std::vector<std::vector<double>> Heights; // by horizon, then by vertex
  std::vector<Triangles> Patches;
  int Passes = 0;
  bool AreWhole = false; // one group for each patch
};
}

//----------------------------------------------------------------------------------------------------------------------
void ImproveInGroups(HeightMesh& mesh, const DecimationOptions& options, const ColumnRule& rule, const Monitor& monitor)
{
  MeshGroups groups(mesh, options, rule);
  groups.SetError(options.MaximumError);
  groups.CollapseWithinError(monitor.Step(0.0, 0.4));
  groups.ImproveRest(monitor.Step(0.4, 1.0));
  groups.GiveBack();
}

//----------------------------------------------------------------------------------------------------------------------
void SmoothInGroups(HeightMesh& mesh, const DecimationOptions& options, const Monitor& monitor)
{
  const double largest = std::max(mesh.LargestError(), LeastOfSearch);
  const double bound = options.Priority == DecimationPriority::LargestError ? largest : FirstBound * largest;
  const ColumnRule noRule;
  MeshGroups groups(mesh, options, noRule);
  groups.SetError(bound, options.Priority == DecimationPriority::LargestError ? 4 : 2);
  groups.Smooth(monitor);
  groups.GiveBack();
}

//----------------------------------------------------------------------------------------------------------------------
void ReduceToNumber(
  HeightMesh& mesh, std::size_t vertices, double error, const DecimationOptions& options, const Monitor& monitor)
{
  const double bound = std::max(error, LeastOfSearch);
  const ColumnRule noRule;
  MeshGroups groups(mesh, options, noRule);
  groups.SetError(bound, 2);
  groups.ReduceTo(vertices, monitor);
  groups.GiveBack();
}

namespace
{
/// Searches the error that leaves a number of vertices, or a few less. Numbers are relative to it.
class ErrorSearch
{
public:
  explicit ErrorSearch(double first)
    : Next(first)
  {
  }

  double NextError() const { return this->Next; }

  /// Takes what is left within the next error, or what collapses leave of it.
  void Add(double number)
  {
    this->Before = this->Last;
    this->Last = { this->Next, number };
    const auto place = std::upper_bound(this->Trials.begin(), this->Trials.end(), this->Last,
      [](const Trial& one, const Trial& other) { return one.Error < other.Error; });
    this->Trials.insert(place, this->Last);
    ++this->NumberOfTrials;
    this->FindNext();
    this->Farthest *= this->CountFine() == this->Trials.size() ? this->Farthest : 1.0;
  }

  /// Returns whether the mesh that collapses left is worth improving.
  bool IsPromising() const { return this->IsNear() || this->IsNarrow() || this->IsLate(); }

  /// Takes what the improved mesh of the last error has.
  void Improve(double number)
  {
    this->Left = number / this->Last.Number;
    this->FindNext();
  }

  /// The next errors are for the mesh of the last one, which has too many vertices.
  void Continue()
  {
    this->Last.Number *= this->Left;
    this->Left = 1.0;
    this->Trials = { this->Last };
    this->Before = Trial();
    this->FindNext();
  }

  /// Few enough vertices are left, and no error that is much smaller may do.
  bool IsDone() const
  {
    const std::size_t fine = this->CountFine();
    if (fine == this->Trials.size())
    {
      return false;
    }
    const Trial& best = this->IsFine(this->Last) ? this->Trials[fine] : this->Last;
    const double number = this->Left * best.Number;
    const double error = std::pow(number, 1.0 / std::min(this->Power, NumberPower)); // of this one, less would do
    return number >= EnoughOfNumber || error >= EnoughOfError || this->IsNarrow() || this->IsLate();
  }

private:
  struct Trial
  {
    double Error = 0.0; // 0 for none
    double Number = 0.0;
  };

  bool IsNear() const
  {
    const double expected = this->Left * this->Last.Number;
    return expected >= LeastExpected && expected <= MostExpected;
  }

  bool IsLate() const { return this->NumberOfTrials >= MostTrials; }

  bool IsFine(const Trial& trial) const { return this->Left * trial.Number > 1.0; }

  /// Numbers fall as errors grow, apart from noise.
  std::size_t CountFine() const
  {
    const auto coarse = std::find_if(
      this->Trials.begin(), this->Trials.end(), [this](const Trial& trial) { return !this->IsFine(trial); });
    return std::size_t(coarse - this->Trials.begin());
  }

  bool IsNarrow() const
  {
    const std::size_t fine = this->CountFine();
    return fine > 0 && fine < this->Trials.size() &&
      this->Trials[fine].Error <= NearEnough * this->Trials[fine - 1].Error;
  }

  void FindNext()
  {
    const std::size_t fine = this->CountFine();
    const std::size_t all = this->Trials.size();
    if (all > 1)
    {
      const std::size_t pair = std::clamp<std::size_t>(fine, 1, all - 1);
      this->Power = PowerBetween(this->Trials[pair - 1], this->Trials[pair]);
    }
    const bool isFromCoarse = fine == 0 || (fine < all && !this->IsFine(this->Last));
    const Trial& from = this->Trials[isFromCoarse ? fine : fine - 1];
    const double factor = std::pow(this->Left * from.Number / AimOfSearch, 1.0 / this->Power);
    const double least = fine == 0 ? 0.0 : Away * this->Trials[fine - 1].Error;
    const double most = fine == all ? std::numeric_limits<double>::infinity() : this->Trials[fine].Error / Away;
    const bool isBetween = fine > 0 && fine < all;
    const bool isSlow =
      !this->IsNear() && this->Before.Error > 0.0 && this->IsFine(this->Before) == this->IsFine(this->Last);
    this->Next = isBetween && (isSlow || least > most)
      ? std::sqrt(least * most)
      : std::clamp(from.Error * std::clamp(factor, 1.0 / this->Farthest, this->Farthest), least, most);
  }

  /// The number falls as the error to this power.
  static double PowerBetween(const Trial& fine, const Trial& coarse)
  {
    const double power = std::log(fine.Number / coarse.Number) / std::log(coarse.Error / fine.Error);
    return std::clamp(power, LeastPower, MostPower);
  }

  double Next;
  double Power = NumberPower;
  double Farthest = FarthestStep;
  double Left = 1.0; // in the end, of what collapses leave
  std::vector<Trial> Trials; // by error
  Trial Last;
  Trial Before;
  int NumberOfTrials = 0;
};
}

//----------------------------------------------------------------------------------------------------------------------
// Meshes are inserted and collapsed until about the number is expected, then improved. Where that leaves too many, the
// error grows from there; errors that leave too few are tried again from the mesh before.
void ReduceLargestError(
  HeightMesh& mesh, const DecimationOptions& options, const InsertWithin& insert, const Monitor& monitor)
{
  const ColumnRule noRule;
  ErrorSearch search(options.MaximumError);
  double most = 0.0;
  std::optional<MeshGroups> fine;
  std::optional<MeshGroups> coarse;
  for (int trial = 0; trial < MostTrials && !(coarse && search.IsDone()); ++trial)
  {
    const Monitor step = monitor.Step(double(trial) / MostTrials, double(trial + 1) / MostTrials);
    if (!fine)
    {
      coarse.reset();
      most = double(insert(search.NextError(), step.Step(0.0, 0.4)));
    }
    MeshGroups next = fine ? *fine : MeshGroups(mesh, options, noRule);
    next.SetError(search.NextError());
    const double collapsed = next.CollapseWithinError(step.Step(0.4, 0.6)) / most;
    if (!fine)
    {
      search.Add(collapsed);
      if (!search.IsPromising())
      {
        continue;
      }
    }
    if (!fine || double(next.CountVertices()) > most)
    {
      next.ImproveRest(step.Step(0.6, 1.0));
    }
    const double number = double(next.CountVertices()) / most;
    const bool isFine = number > 1.0;
    fine ? search.Add(number) : search.Improve(number);
    if (isFine && fine && next.CountVertices() == fine->CountVertices())
    {
      break;
    }
    if (isFine && !fine)
    {
      search.Continue();
    }
    (isFine ? fine : coarse).emplace(std::move(next));
  }
  if (!coarse) // where angles keep vertices at any error
  {
    fine->SetError(search.NextError(), 2);
    fine->ReduceTo(std::size_t(most), Monitor());
  }
  (coarse ? *coarse : *fine).GiveBack();
}
}
