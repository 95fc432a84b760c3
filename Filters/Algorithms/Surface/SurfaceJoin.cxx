// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// In this order: seams simplified; loops assembled from edges; the parts joined along their rows.

#include "SurfaceJoin.h"

#include "Common/Base/DisjointSets.h"
#include "Common/Base/Errors.h"
#include "Common/Horizon/MeshChecker.h"
#include "Common/Horizon/Predicates.h"
#include "Common/Horizon/SpacePoints.h"
#include "Common/Horizon/Types.h"
#include "Filters/Algorithms/BoundarySimplification/FewestPoints.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
// ---- Seams ----------------------------------------------------------------------------------------------------------
constexpr std::int32_t NotOnSeam = -1;
// FewestPoints keeps points with this number of visits.
constexpr unsigned char Stays = 2;

/// Points are numbered from left to right.
class Seam
{
public:
  Seam(PlanePoints columns, std::int32_t row, bool isUpper, const BoundaryOptions& options)
    : Columns(columns)
    , IsUpper(isUpper)
    , Radius(options.Radius)
    , LongestEdge(std::max(options.Radius, options.Seams.LongestEdge))
    , Number(columns.size(), NotOnSeam)
  {
    for (std::size_t point = 0; point < columns.size(); ++point)
    {
      if (columns[point].Y == row)
      {
        this->Points.push_back(PointId(point));
      }
    }
    std::sort(this->Points.begin(), this->Points.end(), [&](PointId a, PointId b) { return this->X(a) < this->X(b); });
    for (std::size_t n = 0; n < this->Points.size(); ++n)
    {
      this->Number[this->Points[n]] = std::int32_t(n);
    }
    this->IsNode.assign(this->Points.size(), 0);
  }

  void FindNodes(const std::vector<double>& height, double heightTolerance)
  {
    std::vector<PlanePoint> places;
    std::vector<double> heights;
    for (const PointId point : this->Points)
    {
      places.push_back({ this->X(point), 0 });
      heights.push_back(height[point]);
    }
    const std::vector<unsigned char> visits(places.size(), Stays);
    const SpacePoints points(places, heights, 1);
    const ColumnIndex index(places);
    KeptOfChains known;
    FewestPoints fewest(points, index, visits, 0.0, heightTolerance, known, []() {});
    for (std::size_t from = 0; from < this->Points.size();)
    {
      std::size_t to = from + 1;
      for (; to < this->Points.size() && this->StepTo(to) <= this->LongestEdge; ++to)
      {
      }
      std::vector<PointId> chain(to - from);
      std::iota(chain.begin(), chain.end(), PointId(from));
      for (const std::size_t position : fewest.SimplifyChain(chain))
      {
        this->IsNode[from + position] = 1;
      }
      from = to;
    }
    this->IsKept = this->IsNode;
  }

  /// Turns of loops are kept, and ends of gaps that loops follow on the side of the surface.
  void KeepTurns(const PointId* loop, std::size_t length)
  {
    for (std::size_t n = 0; n < length; ++n)
    {
      const std::int32_t before = this->Number[loop[(n + length - 1) % length]];
      const std::int32_t here = this->Number[loop[n]];
      const std::int32_t after = this->Number[loop[(n + 1) % length]];
      if (here != NotOnSeam && (before == NotOnSeam || after == NotOnSeam || after - here != here - before))
      {
        this->IsKept[here] = 1;
      }
      // Along the other side, loops run right on an upper seam, left on a lower seam.
      const bool isInside = here != NotOnSeam && after != NotOnSeam && after - here == (this->IsUpper ? -1 : 1);
      if (isInside && this->StepTo(std::size_t(std::max(here, after))) > this->Radius)
      {
        this->IsKept[here] = 1;
        this->IsKept[after] = 1;
        this->OpenGaps.push_back(this->Points[std::min(here, after)]);
      }
    }
  }

  bool IsDropped(PointId point) const
  {
    const std::int32_t number = this->Number[point];
    return number != NotOnSeam && this->IsKept[number] == 0;
  }

  void Write(const std::vector<double>& height, SeamChains& result) const
  {
    result.OpenGaps.insert(result.OpenGaps.end(), this->OpenGaps.begin(), this->OpenGaps.end());
    for (std::size_t n = 0; n < this->Points.size(); ++n)
    {
      if (this->IsNode[n] == 0)
      {
        this->WriteBetweenNodes(n, height, result);
      }
      if (this->IsKept[n] != 0)
      {
        result.Kept.push_back(this->Points[n]);
      }
      else
      {
        const PointId left = this->Points[this->Before(n, this->IsKept)];
        const PointId right = this->Points[this->After(n, this->IsKept)];
        const std::int32_t x = this->X(this->Points[n]);
        result.Dropped.push_back({ this->Points[n], this->X(right) - x < x - this->X(left) ? right : left });
      }
    }
  }

private:
  std::int32_t X(PointId point) const { return this->Columns[point].X; }
  std::int32_t StepTo(std::size_t n) const { return this->X(this->Points[n]) - this->X(this->Points[n - 1]); }

  /// The ends of a seam are marked, which ends the search.
  static std::size_t Before(std::size_t n, const std::vector<unsigned char>& marks)
  {
    for (--n; marks[n] == 0; --n)
    {
    }
    return n;
  }
  static std::size_t After(std::size_t n, const std::vector<unsigned char>& marks)
  {
    for (++n; marks[n] == 0; ++n)
    {
    }
    return n;
  }

  void WriteBetweenNodes(std::size_t n, const std::vector<double>& height, SeamChains& result) const
  {
    const auto place = [&](std::size_t number)
    {
      const PointId point = this->Points[number];
      return Eigen::Vector3d(double(this->X(point)), 0.0, height[point]);
    };
    const Eigen::Vector3d left = place(this->Before(n, this->IsNode));
    const Eigen::Vector3d right = place(this->After(n, this->IsNode));
    const Eigen::Vector3d here = place(n);
    result.Deviation = std::max(result.Deviation, SpanningEdge(left, right).InSpace(here));
    const double fraction = (here.x() - left.x()) / (right.x() - left.x());
    const double onLine = left.z() + fraction * (right.z() - left.z());
    result.HeightDeviation = std::max(result.HeightDeviation, std::abs(here.z() - onLine));
    if (this->IsKept[n] != 0)
    {
      result.Pins.push_back({ this->Points[n], onLine });
    }
  }

  const PlanePoints Columns;
  const bool IsUpper;
  const std::int32_t Radius;
  const std::int32_t LongestEdge;
  std::vector<PointId> Points;
  std::vector<std::int32_t> Number; // by point
  std::vector<unsigned char> IsNode;
  std::vector<unsigned char> IsKept;
  std::vector<PointId> OpenGaps;
};

// ---- Loops ----------------------------------------------------------------------------------------------------------
using Path = std::vector<PointId>;

/// Finds loops and patches of the joined vertices and triangles. Edges must be loops with triangles to their right,
/// without crossings, else InputError. A vertex without edges and triangles is a patch.
///
/// Outlines, one per patch, precede holes, both by rows from the least y. Each begins at its point of least x, then
/// least y.
class Assembler
{
public:
  Assembler(std::vector<Edge> edges, JoinedSurface& result)
    : Result(result)
    , Edges(std::move(edges))
    , IsWalked(this->Edges.size(), false)
    , IsUsed(result.Vertices.size(), false)
    , Connected(result.Vertices.size())
  {
    std::sort(this->Edges.begin(), this->Edges.end(),
      [](const Edge& a, const Edge& b) { return std::tie(a.From, a.To) < std::tie(b.From, b.To); });
    for (const Edge& edge : this->Edges)
    {
      this->Connect(edge.From, edge.To);
    }
    for (std::size_t corner = 0; corner < result.Triangles.size(); corner += 3)
    {
      this->Connect(result.Triangles[corner], result.Triangles[corner + 1]);
      this->Connect(result.Triangles[corner], result.Triangles[corner + 2]);
    }
  }

  void Run()
  {
    for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
    {
      if (!this->IsWalked[edge])
      {
        this->Add(this->Walk(edge));
      }
    }
    for (std::size_t vertex = 0; vertex < this->IsUsed.size(); ++vertex)
    {
      if (!this->IsUsed[vertex])
      {
        this->Outlines.push_back({ PointId(vertex) });
      }
    }
    this->Number();
  }

private:
  const PlanePoint& At(PointId vertex) const { return this->Result.Vertices[vertex]; }

  void Connect(PointId a, PointId b)
  {
    this->Connected.Join(a, b);
    this->IsUsed[a] = true;
    this->IsUsed[b] = true;
  }

  /// Follows the face to the left of an edge (Boundary/Hops.h).
  Path Walk(std::size_t edge)
  {
    Path path;
    while (!this->IsWalked[edge])
    {
      this->IsWalked[edge] = true;
      path.push_back(this->Edges[edge].From);
      edge = this->Next(this->Edges[edge]);
    }
    if (this->Edges[edge].From != path.front())
    {
      throw InputError("a loop that does not return to its vertex " + std::to_string(path.front()) +
        ", expected parts whose seams fit");
    }
    return path;
  }

  /// Returns the edge that a clockwise sweep meets first; the edge back comes last.
  std::size_t Next(const Edge& edge) const
  {
    const auto first = std::lower_bound(
      this->Edges.begin(), this->Edges.end(), edge.To, [](const Edge& a, PointId vertex) { return a.From < vertex; });
    const auto last = std::find_if(first, this->Edges.end(), [&edge](const Edge& a) { return a.From != edge.To; });
    const auto next = std::min_element(
      first, last, [&](const Edge& a, const Edge& b) { return this->IsSweptBefore(edge, a.To, b.To); });
    if (next == last)
    {
      throw InputError("no edge continues from vertex " + std::to_string(edge.To) + ", expected parts whose seams fit");
    }
    return std::size_t(next - this->Edges.begin());
  }

  /// Sorts directions by the clockwise angle: less than half a turn, half, more, a whole turn.
  int QuarterOf(const Edge& edge, PointId vertex) const
  {
    const PlanePoint& here = this->At(edge.To);
    const std::int64_t side = SignedArea(here, this->At(edge.From), this->At(vertex));
    if (side == 0)
    {
      return ScalarProduct(here, this->At(edge.From), this->At(vertex)) < 0 ? 1 : 3;
    }
    return side < 0 ? 0 : 2;
  }

  bool IsSweptBefore(const Edge& edge, PointId a, PointId b) const
  {
    const int quarterA = this->QuarterOf(edge, a);
    const int quarterB = this->QuarterOf(edge, b);
    return quarterA != quarterB ? quarterA < quarterB : SignedArea(this->At(edge.To), this->At(a), this->At(b)) < 0;
  }

  void Add(Path path)
  {
    Int128 area = 0;
    for (std::size_t n = 0; n < path.size(); ++n)
    {
      area += SignedArea(this->At(path.front()), this->At(path[n]), this->At(path[(n + 1) % path.size()]));
    }
    std::rotate(path.begin(),
      std::min_element(path.begin(), path.end(), [this](PointId a, PointId b) { return this->At(a) < this->At(b); }),
      path.end());
    (area > 0 ? this->Holes : this->Outlines).push_back(std::move(path));
  }

  void SortAsMet(std::vector<Path>& paths) const
  {
    const auto firstOf = [this](const Path& path)
    {
      return this->At(*std::min_element(
        path.begin(), path.end(), [this](PointId a, PointId b) { return PrecedesByRow(this->At(a), this->At(b)); }));
    };
    std::vector<std::pair<PlanePoint, Path>> order;
    order.reserve(paths.size());
    for (Path& path : paths)
    {
      const PlanePoint first = firstOf(path);
      order.emplace_back(first, std::move(path));
    }
    std::stable_sort(
      order.begin(), order.end(), [](const auto& a, const auto& b) { return PrecedesByRow(a.first, b.first); });
    std::transform(order.begin(), order.end(), paths.begin(), [](auto& entry) { return std::move(entry.second); });
  }

  void Number()
  {
    this->SortAsMet(this->Outlines);
    this->SortAsMet(this->Holes);
    constexpr std::int32_t none = -1;
    std::vector<std::int32_t> number(this->IsUsed.size(), none);
    for (const Path& path : this->Outlines)
    {
      std::int32_t& patch = number[this->Connected.Find(path.front())];
      if (patch != none)
      {
        throw InputError("two outlines of one patch, one of them at vertex " + std::to_string(path.front()) +
          ", expected parts whose seams fit");
      }
      patch = std::int32_t(this->Result.NumberOfPatches++);
    }
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex)
    {
      this->Result.Patch.push_back(number[this->Connected.Find(std::int32_t(vertex))]);
    }
    for (const std::vector<Path>* paths : { &this->Outlines, &this->Holes })
    {
      for (const Path& path : *paths)
      {
        std::for_each(path.begin(), path.end(), [this](PointId vertex) { this->Result.Boundary.Append(vertex); });
        this->Result.Boundary.Close();
      }
    }
  }

  JoinedSurface& Result;
  std::vector<Edge> Edges; // by first, then second vertex
  std::vector<bool> IsWalked;
  std::vector<bool> IsUsed; // has an edge or a triangle
  DisjointSets Connected;
  std::vector<Path> Outlines;
  std::vector<Path> Holes;
};

// ---- Parts ----------------------------------------------------------------------------------------------------------
// Heights on the line of a seam may differ by this, in lattice units, or relative to heights above 1.
constexpr double SeamRounding = 1e-6;

using SeamVertices = std::map<std::int32_t, PointId>;

std::string RowText(const std::optional<std::int32_t>& row)
{
  return row ? "row " + std::to_string(*row) : std::string("none");
}

class PartJoiner
{
public:
  explicit PartJoiner(const std::vector<SurfacePart>& parts)
    : Parts(parts)
    , Seams(parts.size())
    , Number(parts.size())
  {
  }

  JoinedSurface Run(std::int64_t minimumPatchSize)
  {
    for (std::size_t part = 0; part < this->Parts.size(); ++part)
    {
      this->CheckSeams(part);
      this->NumberVertices(part);
    }
    this->FindOpenGaps();
    for (std::size_t part = 0; part < this->Parts.size(); ++part)
    {
      this->AddEdges(part);
      this->AddTriangles(part);
    }
    Assembler(std::move(this->Edges), this->Result).Run();
    if (minimumPatchSize > 1)
    {
      this->DropSmallPatches(minimumPatchSize);
    }
    this->CountSeamVertices();
    return std::move(this->Result);
  }

private:
  void CheckSeams(std::size_t part) const
  {
    const std::optional<std::int32_t> before =
      part == 0 ? std::optional<std::int32_t>() : this->Parts[part - 1].Seams.Upper;
    const std::optional<std::int32_t>& lower = this->Parts[part].Seams.Lower;
    if (lower != before || (part > 0 && !lower))
    {
      throw InputError("part " + std::to_string(part) + " with its lower seam at " + RowText(lower) + ", expected " +
        (part == 0 ? std::string("none below the first part") : "that above the part before, " + RowText(before)));
    }
    if (part + 1 == this->Parts.size() && this->Parts[part].Seams.Upper)
    {
      throw InputError("the last part with its upper seam at " + RowText(this->Parts[part].Seams.Upper) +
        ", expected a part beyond it");
    }
  }

  /// Seams have the number of the part below; the number of parts means none.
  std::size_t SeamOf(std::size_t part, PointId vertex) const
  {
    const SurfacePart& here = this->Parts[part];
    const std::int32_t row = here.Vertices[vertex].Y;
    return here.Seams.Upper && row == *here.Seams.Upper ? part
      : here.Seams.Lower && row == *here.Seams.Lower    ? part - 1
                                                        : this->Parts.size();
  }

  void NumberVertices(std::size_t part)
  {
    const SurfacePart& here = this->Parts[part];
    for (std::size_t vertex = 0; vertex < here.Vertices.size(); ++vertex)
    {
      const std::size_t seam = this->SeamOf(part, PointId(vertex));
      PointId number = PointId(this->Result.Vertices.size());
      if (seam < this->Parts.size())
      {
        number = this->Seams[seam].emplace(here.Vertices[vertex].X, number).first->second;
      }
      this->Number[part].push_back(number);
      if (std::size_t(number) < this->Result.Vertices.size())
      {
        this->CheckHeight(number, here.Height[vertex], here.Height[vertex]);
        this->Result.Count[number] += here.Count[vertex];
        continue;
      }
      this->Result.Sources.push_back({ std::int32_t(part), std::int32_t(vertex) });
      this->Result.Vertices.push_back(here.Vertices[vertex]);
      this->Result.Count.push_back(here.Count[vertex]);
    }
  }

  double HeightOf(PointId vertex) const
  {
    const PartItem& source = this->Result.Sources[vertex];
    return this->Parts[source.Part].Height[source.Item];
  }

  void CheckHeight(PointId vertex, double height, double size) const
  {
    const double off = std::abs(this->HeightOf(vertex) - height);
    if (!(off <= SeamRounding * std::max(1.0, std::abs(size))))
    {
      const PlanePoint& column = this->Result.Vertices[vertex];
      std::ostringstream text;
      text << "heights " << this->HeightOf(vertex) << " and " << height << " in column (" << column.X << ", "
           << column.Y << ") on both sides of a seam, expected the same: parts of one horizon with the same parameters";
      throw InputError(text.str());
    }
  }

  /// A gap is known by the vertex to its left.
  void FindOpenGaps()
  {
    for (std::size_t part = 0; part < this->Parts.size(); ++part)
    {
      for (const PointId vertex : this->Parts[part].OpenGaps)
      {
        const bool isUpper = this->SeamOf(part, vertex) == part;
        (isUpper ? this->OpenBelow : this->OpenAbove).insert(this->Number[part][vertex]);
      }
    }
  }

  /// Splits edges along a seam at its vertices.
  template <typename Visitor>
  void ForEachPiece(std::size_t part, PointId from, PointId to, Visitor&& visit) const
  {
    const std::size_t seam = this->SeamOf(part, from);
    PointId last = this->Number[part][from];
    const PointId end = this->Number[part][to];
    if (seam < this->Parts.size() && seam == this->SeamOf(part, to))
    {
      const std::int32_t x = this->Result.Vertices[last].X;
      const std::int32_t endX = this->Result.Vertices[end].X;
      std::vector<PointId> between;
      const auto first = this->Seams[seam].upper_bound(std::min(x, endX));
      const auto stop = this->Seams[seam].lower_bound(std::max(x, endX));
      std::transform(first, stop, std::back_inserter(between), [](const auto& entry) { return entry.second; });
      if (endX < x)
      {
        std::reverse(between.begin(), between.end());
      }
      for (const PointId vertex : between)
      {
        visit(last, vertex);
        last = vertex;
      }
    }
    visit(last, end);
  }

  void AddEdges(std::size_t part)
  {
    std::set<PointId> covered;
    this->Parts[part].Boundary.ForEachPoint([&](PointId vertex) { covered.insert(this->Number[part][vertex]); });
    this->Parts[part].Boundary.ForEachEdge(
      [&](PointId from, PointId to)
      {
        const std::size_t seam = this->SeamOf(part, from);
        const bool isAlong = seam < this->Parts.size() && seam == this->SeamOf(part, to);
        this->ForEachPiece(part, from, to,
          [&](PointId a, PointId b)
          {
            covered.insert(b);
            if (!isAlong || this->IsLeft(part, seam, a, b))
            {
              this->Edges.push_back({ a, b });
            }
          });
        if (isAlong)
        {
          this->CheckLine(part, from, to);
        }
      });
    this->CheckCovered(part, covered);
  }

  /// Loops along a seam with the part on their left belong to the joined mesh, except across open gaps.
  bool IsLeft(std::size_t part, std::size_t seam, PointId from, PointId to) const
  {
    const bool isRightward = this->Result.Vertices[from].X < this->Result.Vertices[to].X;
    const bool isOwn = isRightward != (seam == part);
    const PointId left = isRightward ? from : to;
    return isOwn && !(this->OpenBelow.count(left) != 0 && this->OpenAbove.count(left) != 0);
  }

  /// Vertices that split an edge must lie on it.
  void CheckLine(std::size_t part, PointId from, PointId to) const
  {
    const SurfacePart& here = this->Parts[part];
    const double fromX = here.Vertices[from].X;
    const double width = here.Vertices[to].X - fromX;
    const double fromHeight = here.Height[from];
    const double rise = here.Height[to] - fromHeight;
    const PointId end = this->Number[part][to];
    this->ForEachPiece(part, from, to,
      [&](PointId, PointId vertex)
      {
        if (vertex != end)
        {
          const double way = (this->Result.Vertices[vertex].X - fromX) / width;
          this->CheckHeight(vertex, fromHeight + way * rise, std::max(std::abs(fromHeight), std::abs(rise)));
        }
      });
  }

  /// Both parts must run along a seam at the same columns.
  void CheckCovered(std::size_t part, const std::set<PointId>& covered) const
  {
    for (std::size_t seam = part > 0 ? part - 1 : part; seam <= part; ++seam)
    {
      for (const auto& [x, vertex] : this->Seams[seam])
      {
        if (covered.count(vertex) == 0)
        {
          throw InputError("no edge of part " + std::to_string(part) + " at column (" + std::to_string(x) + ", " +
            std::to_string(this->Result.Vertices[vertex].Y) +
            ") of its seam, expected parts of one horizon with the same parameters");
        }
      }
    }
  }

  void AddTriangles(std::size_t part)
  {
    const SurfacePart& here = this->Parts[part];
    for (std::size_t corner = 0; corner < here.Triangles.size(); corner += 3)
    {
      std::array<PointId, 3> corners = { here.Triangles[corner], here.Triangles[corner + 1],
        here.Triangles[corner + 2] };
      const auto isAlong = [&]()
      {
        const std::size_t seam = this->SeamOf(part, corners[0]);
        return seam < this->Parts.size() && seam == this->SeamOf(part, corners[1]);
      };
      for (int turn = 0; turn < 3 && !isAlong(); ++turn)
      {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      }
      const PointId apex = this->Number[part][corners[2]];
      this->ForEachPiece(part, corners[0], corners[1],
        [&](PointId a, PointId b)
        {
          this->Result.Triangles.insert(this->Result.Triangles.end(), { a, b, apex });
          this->Result.TriangleSources.push_back({ std::int32_t(part), std::int32_t(corner / 3) });
        });
    }
  }

  void DropSmallPatches(std::int64_t minimumSize)
  {
    std::vector<std::int64_t> size(this->Result.NumberOfPatches, 0);
    for (std::size_t vertex = 0; vertex < this->Result.Vertices.size(); ++vertex)
    {
      size[this->Result.Patch[vertex]] += this->Result.Count[vertex];
    }
    std::vector<std::int32_t> patchNumber(size.size(), NoPatch);
    std::int32_t patches = 0;
    for (std::size_t patch = 0; patch < size.size(); ++patch)
    {
      const bool isSmall = size[patch] < minimumSize;
      this->Result.DroppedPoints += isSmall ? size[patch] : 0;
      patchNumber[patch] = isSmall ? NoPatch : patches++;
    }
    this->Result.NumberOfPatches = std::size_t(patches);
    this->Keep(patchNumber);
  }

  void Keep(const std::vector<std::int32_t>& patchNumber)
  {
    JoinedSurface all = std::exchange(this->Result, JoinedSurface());
    this->Result.NumberOfPatches = all.NumberOfPatches;
    this->Result.DroppedPoints = all.DroppedPoints;
    const auto patchOf = [&](PointId vertex) { return patchNumber[all.Patch[vertex]]; };
    std::vector<PointId> number(all.Vertices.size(), NoPoint);
    for (std::size_t vertex = 0; vertex < number.size(); ++vertex)
    {
      if (patchOf(PointId(vertex)) != NoPatch)
      {
        number[vertex] = PointId(this->Result.Vertices.size());
        this->Result.Vertices.push_back(all.Vertices[vertex]);
        this->Result.Sources.push_back(all.Sources[vertex]);
        this->Result.Count.push_back(all.Count[vertex]);
        this->Result.Patch.push_back(patchOf(PointId(vertex)));
      }
    }
    for (std::size_t corner = 0; corner < all.Triangles.size(); ++corner)
    {
      const PointId vertex = number[all.Triangles[corner]];
      if (vertex != NoPoint)
      {
        this->Result.Triangles.push_back(vertex);
      }
      if (vertex != NoPoint && corner % 3 == 0)
      {
        this->Result.TriangleSources.push_back(all.TriangleSources[corner / 3]);
      }
    }
    for (std::size_t loop = 0; loop < all.Boundary.Size(); ++loop)
    {
      if (patchOf(*all.Boundary.begin(loop)) != NoPatch)
      {
        this->Result.Boundary.AppendLoop(all.Boundary, loop);
      }
    }
    this->Result.Boundary = this->Result.Boundary.Renumbered(number);
  }

  void CountSeamVertices()
  {
    const std::vector<unsigned char> isOnLoop = this->Result.Boundary.MarkPoints(this->Result.Vertices.size());
    for (std::size_t vertex = 0; vertex < isOnLoop.size(); ++vertex)
    {
      const PartItem& source = this->Result.Sources[vertex];
      const bool isOnSeam = this->SeamOf(std::size_t(source.Part), source.Item) < this->Parts.size();
      this->Result.SeamVertices += isOnSeam && isOnLoop[vertex] == 0 ? 1 : 0;
    }
  }

  const std::vector<SurfacePart>& Parts;
  std::vector<SeamVertices> Seams; // by the part below
  std::vector<std::vector<PointId>> Number; // by part and vertex
  std::set<PointId> OpenBelow;
  std::set<PointId> OpenAbove;
  std::vector<Edge> Edges; // of remaining loops
  JoinedSurface Result;
};
}

//----------------------------------------------------------------------------------------------------------------------
SeamChains SimplifySeams(PlanePoints columns, const std::vector<double>& height, const Loops& boundary,
  const BoundaryOptions& options, double heightTolerance)
{
  assert(columns.size() == height.size());
  std::vector<Seam> seams;
  for (const bool isUpper : { false, true })
  {
    const std::optional<std::int32_t>& row = isUpper ? options.Seams.Upper : options.Seams.Lower;
    const auto isOnRow = [&row](const PlanePoint& column) { return column.Y == *row; };
    if (row && std::any_of(columns.begin(), columns.end(), isOnRow))
    {
      seams.emplace_back(columns, *row, isUpper, options);
    }
  }
  SeamChains result;
  for (Seam& seam : seams)
  {
    seam.FindNodes(height, heightTolerance);
    for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
    {
      seam.KeepTurns(boundary.begin(loop), boundary.Length(loop));
    }
    seam.Write(height, result);
  }
  const auto isDropped = [&seams](PointId point)
  { return std::any_of(seams.begin(), seams.end(), [point](const Seam& seam) { return seam.IsDropped(point); }); };
  for (std::size_t loop = 0; loop < boundary.Size(); ++loop)
  {
    std::for_each(boundary.begin(loop), boundary.end(loop),
      [&](PointId point)
      {
        if (!isDropped(point))
        {
          result.Boundary.Append(point);
        }
      });
    result.Boundary.Close();
  }
  return result;
}

//----------------------------------------------------------------------------------------------------------------------
JoinedSurface JoinSurface(const std::vector<SurfacePart>& parts, std::int64_t minimumPatchSize)
{
  JoinedSurface joined = PartJoiner(parts).Run(minimumPatchSize);
  if (MeshChecker::IsOn)
  {
    MeshChecker::Require("JoinSurface", joined.Vertices, joined.Boundary, joined.Triangles, MeshChecker::Kind::Any);
  }
  return joined;
}
}
