// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cells and bodies of plans that are given as pictures of thicknesses, with the parts and points they must have.

#include "ClosedBodies.h"
#include "Filters/Algorithms/Layers/LayerBody.h"
#include "Filters/Algorithms/Layers/LayerCells.h"
#include "Tools/Check.h"

#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
/// A vertex for each digit, which is the thickness there; a space for none. Squares are cut from the lower left to the
/// upper right. The first row is that of y = 0. The base is level, at 10.
LayerPlan FromPicture(const std::vector<std::string>& rows, bool downwards = false)
{
  LayerPlan plan;
  plan.HeightsGrowDownwards = downwards;
  plan.Heights.resize(2);
  std::map<std::pair<int, int>, PointId> numbers;
  for (int y = 0; y < int(rows.size()); ++y)
  {
    for (int x = 0; x < int(rows[std::size_t(y)].size()); ++x)
    {
      const char digit = rows[std::size_t(y)][std::size_t(x)];
      if (digit != ' ')
      {
        numbers[{ x, y }] = PointId(plan.Columns.size());
        plan.Columns.push_back({ x, y });
        plan.Heights[0].push_back(10.0 + (downwards ? -1.0 : 1.0) * (digit - '0'));
        plan.Heights[1].push_back(10.0);
      }
    }
  }
  for (const auto& entry : numbers)
  {
    const auto [x, y] = entry.first;
    const auto add = [&](std::pair<int, int> a, std::pair<int, int> b, std::pair<int, int> c)
    {
      if (numbers.count(a) > 0 && numbers.count(b) > 0 && numbers.count(c) > 0)
      {
        for (const auto& corner : { a, b, c })
        {
          plan.Triangles.push_back(numbers[corner]);
        }
      }
    };
    add({ x, y }, { x + 1, y }, { x + 1, y + 1 });
    add({ x, y }, { x + 1, y + 1 }, { x, y + 1 });
  }
  return plan;
}

struct Body
{
  explicit Body(const LayerPlan& plan)
    : Faces(MakeLayerBody(plan, 0))
  {
    for (std::size_t n = 0; n < this->Faces.Vertices.size(); ++n)
    {
      const PlanePoint& place = plan.Columns[std::size_t(this->Faces.Vertices[n])];
      this->Points.push_back({ double(place.X), double(place.Y), this->Faces.Heights[n] });
    }
    for (std::size_t n = 0; n + 2 < this->Faces.Triangles.size(); n += 3)
    {
      this->Triangles.push_back(
        { this->Faces.Triangles[n], this->Faces.Triangles[n + 1], this->Faces.Triangles[n + 2] });
    }
  }

  int Parts() const
  {
    std::vector<std::size_t> part(this->Points.size());
    for (std::size_t n = 0; n < part.size(); ++n)
    {
      part[n] = n;
    }
    bool isAnyChanged = true;
    while (isAnyChanged)
    {
      isAnyChanged = false;
      for (const auto& t : this->Triangles)
      {
        for (std::size_t n = 0; n < 3; ++n)
        {
          std::size_t& one = part[std::size_t(t[n])];
          const std::size_t other = part[std::size_t(t[(n + 1) % 3])];
          isAnyChanged = isAnyChanged || other < one;
          one = std::min(one, other);
        }
      }
    }
    return int(std::set<std::size_t>(part.begin(), part.end()).size());
  }

  /// Points less edges and triangles: 2 for each part without handles.
  int Euler() const { return int(this->Points.size()) - int(this->Triangles.size()) / 2; }

  LayerBody Faces;
  std::vector<ClosedBodies::Point> Points;
  std::vector<ClosedBodies::Corners> Triangles;
};

/// Handles are the tunnels through a body.
void TestPicture(const std::vector<std::string>& rows, int parts, int handles, std::size_t points)
{
  for (const bool downwards : { false, true })
  {
    const LayerPlan plan = FromPicture(rows, downwards);
    const Body body(plan);
    CHECK_EQUAL(ClosedBodies::CheckClosed(body.Points, body.Triangles), std::string());
    CHECK_EQUAL(body.Parts(), parts);
    CHECK_EQUAL(body.Euler(), 2 * (parts - handles));
    CHECK_EQUAL(body.Points.size(), points);
    const double volume = MeasureLayer(plan, 0).Volume;
    CHECK(std::abs(ClosedBodies::EnclosedVolume(body.Points, body.Triangles) - volume) < 1e-12);
  }
}

void TestBodies()
{
  TestPicture({ "11", "11" }, 1, 0, 8);
  TestPicture({ "10", "11" }, 1, 0, 7); // the outline closes where it has no height
  TestPicture({ "000", "010", "000" }, 1, 0, 8); // a cone: both other corners of the square are without a cell
  TestPicture({ "111", "101", "111" }, 1, 0, 18); // pierced at one column: two points
  TestPicture({ "1111", "1001", "1111" }, 1, 0, 24); // and along an edge inside, which stays whole
  TestPicture({ "101", "101", "101" }, 2, 0, 18); // parted along a line from outline to outline
  TestPicture({ "101", "101", "111" }, 1, 0, 17); // slit from the outline to a tip, which is one point
  TestPicture({ "10001", "10001", "10001" }, 2, 0, 18); // parted by triangles without a cell
  TestPicture({ "11111", "10001", "10001", "10001", "11111" }, 1, 1, 40); // a ring: the hole is a tunnel
  TestPicture({ "110", "101", "011" }, 1, 0, 16); // no two without thickness are joined by an edge
  TestPicture({ "011", "101", "110" }, 2, 0, 18); // here they are
  TestPicture({ "11 ", "111", " 11" }, 1, 0, 14);
  TestPicture({ "000", "000" }, 0, 0, 0);
}

void TestOneCell(const std::string& corners, double volume, std::size_t points)
{
  for (const bool downwards : { false, true })
  {
    const LayerPlan plan = FromPicture({ corners.substr(0, 2), std::string(" ") + corners[2] }, downwards);
    const LayerCells cells = MakeLayerCells(plan);
    CHECK_EQUAL(plan.NumberOfTriangles(), std::size_t(1));
    CHECK_EQUAL(cells.Size(), std::size_t(volume > 0.0 ? 1 : 0));
    CHECK_EQUAL(cells.Corners.size(), volume > 0.0 ? points : 0);
    CHECK_EQUAL(cells.Vertices.size(), points);
    CHECK_EQUAL(MeasureLayer(plan, 0).Volume, volume);
    CHECK_EQUAL(cells.Size() == 0 ? 0.0 : cells.Volumes.front(), volume);
  }
}

void TestCells()
{
  TestOneCell("222", 1.0, 6);
  TestOneCell("366", 2.5, 6);
  TestOneCell("033", 1.0, 5);
  TestOneCell("303", 1.0, 5);
  TestOneCell("330", 1.0, 5);
  TestOneCell("600", 1.0, 4);
  TestOneCell("060", 1.0, 4);
  TestOneCell("006", 1.0, 4);
  TestOneCell("000", 0.0, 3);
}

/// Of a wedge whose top is at 12, and of a pyramid with its tip at the base: a cut at half its height leaves an eighth.
void TestContacts()
{
  const LayerPlan wedge = FromPicture({ "22", " 2" });
  CHECK_EQUAL(VolumeAbove(wedge, 0, 9.0), 1.0);
  CHECK_EQUAL(VolumeAbove(wedge, 0, 10.0), 1.0);
  CHECK_EQUAL(VolumeAbove(wedge, 0, 11.5), 0.25);
  CHECK_EQUAL(VolumeAbove(wedge, 0, 12.0), 0.0);
  const LayerPlan depths = FromPicture({ "22", " 2" }, true); // from 10 up to 8
  CHECK_EQUAL(VolumeAbove(depths, 0, 8.5), 0.25);
  const LayerPlan tetrahedron = FromPicture({ "60", " 0" });
  CHECK(std::abs(VolumeAbove(tetrahedron, 0, 13.0) - 0.125) < 1e-15);
}

/// Against sums over small triangles.
void TestIntegrals()
{
  constexpr int Parts = 400;
  for (const std::array<double, 3>& v : { std::array<double, 3>{ 1, 2, 3 }, { -1, 2, 3 }, { -3, -1, 2 }, { -1, -2, -3 },
         { 0, 0, 1 }, { -1, 0, 1 }, { 2, -1, 2 }, { 0, 0, 0 }, { -1, -1, 4 } })
  {
    double sum = 0.0;
    for (int a = 0; a < Parts; ++a)
    {
      for (int b = 0; b + a < Parts; ++b)
      {
        const auto at = [&](double x, double y)
        { return std::max(0.0, v[0] + ((v[1] - v[0]) * (a + x) + (v[2] - v[0]) * (b + y)) / Parts); };
        sum += at(1.0 / 3, 1.0 / 3) + (a + b + 1 < Parts ? at(2.0 / 3, 2.0 / 3) : 0.0);
      }
    }
    CHECK(std::abs(IntegrateAboveZero(2.0, v) - 2.0 * sum / (Parts * Parts)) < 1e-4);
  }
}
}

int TestLayerBodies(int, char*[])
{
  TestBodies();
  TestCells();
  TestContacts();
  TestIntegrals();
  return Check::Result();
}
