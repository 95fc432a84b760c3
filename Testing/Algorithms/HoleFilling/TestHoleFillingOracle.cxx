// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random lattices with random cuts, filled again by the definitions: dense matrices of all columns of a part, without
// boxes, bands and levels.

#include "HoleFixtures.h"

#include "Tools/Check.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <map>
#include <set>

using namespace HoleFixtures;

namespace
{
using Column = std::pair<int, int>;

/// The same by definition. Columns and links are looked up in sets.
class Oracle
{
public:
  Oracle(const Horizon& horizon, const LinkCuts& cuts, const HoleFillingOptions& options)
    : Cuts(cuts)
    , Options(options)
  {
    for (std::size_t n = 0; n < horizon.Columns.size(); ++n)
    {
      this->Known[{ horizon.Columns[n].X, horizon.Columns[n].Y }] = horizon.Heights[n];
    }
  }

  /// The height of a column of a part of a gap, all of whose columns are given; nan for a part that is left open, and
  /// where the plate is close to singular, so that results by other ways differ.
  std::map<Column, double> Fill(const std::set<Column>& part)
  {
    std::map<Column, double> result;
    const std::set<Column> ring = this->Ring(part);
    std::map<Column, double> rest;
    for (const Column& column : ring)
    {
      rest[column] = this->Known[column];
    }
    if (this->Options.Method == FillMethod::Plate)
    {
      result = this->Plate(part, ring);
      for (const Column& column : ring)
      {
        rest[column] -= result[column];
      }
      rest = this->WithoutNoise(rest);
    }
    const std::map<Column, double> membrane = this->Membrane(part, rest);
    for (const Column& column : part)
    {
      result[column] += membrane.at(column);
    }
    return result;
  }

  bool IsLinked(const Column& a, const Column& b) const
  {
    const Column first = std::min(a, b);
    const PlanePoint point = { first.first, first.second };
    return a.second == b.second ? !this->Cuts.IsCutEast(point) : !this->Cuts.IsCutNorth(point);
  }

  static std::vector<Column> Neighbours(const Column& c)
  {
    return { { c.first - 1, c.second }, { c.first + 1, c.second }, { c.first, c.second - 1 },
      { c.first, c.second + 1 } };
  }

private:
  bool IsWhole(int x, int y) const
  {
    return this->IsLinked({ x, y }, { x + 1, y }) && this->IsLinked({ x, y }, { x, y + 1 }) &&
      this->IsLinked({ x + 1, y }, { x + 1, y + 1 }) && this->IsLinked({ x, y + 1 }, { x + 1, y + 1 });
  }

  /// Where a step leads to: over a link, or diagonally through a block without cuts.
  std::vector<Column> Steps(const Column& c) const
  {
    std::vector<Column> result;
    for (const Column& neighbour : Neighbours(c))
    {
      if (this->IsLinked(c, neighbour))
      {
        result.push_back(neighbour);
      }
    }
    for (const int dx : { -1, 1 })
    {
      for (const int dy : { -1, 1 })
      {
        if (this->IsWhole(std::min(c.first, c.first + dx), std::min(c.second, c.second + dy)))
        {
          result.push_back({ c.first + dx, c.second + dy });
        }
      }
    }
    return result;
  }

  std::set<Column> Ring(const std::set<Column>& part) const
  {
    std::set<Column> reached = part;
    for (int step = 0; step < this->Options.RimWidth; ++step)
    {
      const std::set<Column> before = reached;
      for (const Column& c : before)
      {
        const std::vector<Column> next = this->Steps(c);
        reached.insert(next.begin(), next.end());
      }
    }
    std::set<Column> ring;
    for (const Column& column : reached)
    {
      if (this->Known.count(column) > 0)
      {
        ring.insert(column);
      }
    }
    return ring;
  }

  /// A stencil of the energy, times the root of its weight; an empty one where a column or a link is missing.
  std::vector<std::pair<Column, double>> Stencil(const std::set<Column>& all, const Column& c, int kind) const
  {
    const int x = c.first;
    const int y = c.second;
    std::vector<std::pair<Column, double>> terms;
    if (kind == 2)
    {
      const double root = std::sqrt(2.0);
      terms = { { { x, y }, root }, { { x + 1, y }, -root }, { { x, y + 1 }, -root }, { { x + 1, y + 1 }, root } };
      if (!this->IsWhole(x, y))
      {
        return {};
      }
    }
    else
    {
      const Column before = kind == 0 ? Column(x - 1, y) : Column(x, y - 1);
      const Column after = kind == 0 ? Column(x + 1, y) : Column(x, y + 1);
      terms = { { before, 1.0 }, { c, -2.0 }, { after, 1.0 } };
      if (!this->IsLinked(before, c) || !this->IsLinked(c, after))
      {
        return {};
      }
    }
    const bool isIn =
      std::all_of(terms.begin(), terms.end(), [&](const auto& term) { return all.count(term.first) > 0; });
    return isIn ? terms : std::vector<std::pair<Column, double>>();
  }

  /// A part of the mean of the means of all columns of the ring that a step leads to.
  std::map<Column, double> WithoutNoise(const std::map<Column, double>& rest) const
  {
    const double part = std::max(0.0, 1.0 - 1.0 / this->Options.RimSmoothing);
    const auto means = [&](const std::map<Column, double>& values)
    {
      std::map<Column, double> result;
      for (const auto& [column, value] : values)
      {
        double sum = value;
        int count = 1;
        for (const Column& other : this->Steps(column))
        {
          const auto found = values.find(other);
          sum += found != values.end() ? found->second : 0.0;
          count += found != values.end() ? 1 : 0;
        }
        result[column] = sum / count;
      }
      return result;
    };
    std::map<Column, double> result = means(means(rest));
    for (auto& [column, value] : result)
    {
      value = part * value + (1.0 - part) * rest.at(column);
    }
    return result;
  }

  std::map<Column, double> Plate(const std::set<Column>& part, const std::set<Column>& ring)
  {
    std::set<Column> all = part;
    all.insert(ring.begin(), ring.end());
    std::map<Column, Eigen::Index> number;
    for (const Column& column : all)
    {
      number.emplace(column, Eigen::Index(number.size()));
    }
    const Eigen::Index size = Eigen::Index(number.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd side = Eigen::VectorXd::Zero(size);
    for (const Column& column : all)
    {
      for (int kind = 0; kind < 3; ++kind)
      {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
        for (const auto& [place, factor] : this->Stencil(all, column, kind))
        {
          row[number[place]] = factor;
        }
        matrix += row * row.transpose();
      }
    }
    const double spring = 1.0 / this->Options.RimSmoothing;
    for (const Column& column : ring)
    {
      matrix(number[column], number[column]) += spring;
      side[number[column]] += spring * this->Known[column];
    }
    const Eigen::VectorXd values = matrix.ldlt().solve(side);
    std::map<Column, double> result;
    for (const auto& [column, n] : number)
    {
      result[column] = values[n];
    }
    const bool isSingular = matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() < 1e-7;
    this->Unsure = this->Unsure || isSingular;
    return result;
  }

  std::map<Column, double> Membrane(const std::set<Column>& part, const std::map<Column, double>& known) const
  {
    std::map<Column, Eigen::Index> number;
    for (const Column& column : part)
    {
      number.emplace(column, Eigen::Index(number.size()));
    }
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(Eigen::Index(part.size()), Eigen::Index(part.size()));
    Eigen::VectorXd side = Eigen::VectorXd::Zero(Eigen::Index(part.size()));
    for (const auto& [column, n] : number)
    {
      for (const Column& neighbour : Neighbours(column))
      {
        if (!this->IsLinked(column, neighbour))
        {
          continue;
        }
        matrix(n, n) += 1.0;
        if (part.count(neighbour) > 0)
        {
          matrix(n, number[neighbour]) -= 1.0;
        }
        else
        {
          side[n] += known.at(neighbour);
        }
      }
    }
    const Eigen::VectorXd values = matrix.ldlt().solve(side);
    std::map<Column, double> result;
    for (const auto& [column, n] : number)
    {
      result[column] = values[n];
    }
    return result;
  }

public:
  bool Unsure = false;

private:
  const LinkCuts& Cuts;
  const HoleFillingOptions& Options;
  std::map<Column, double> Known;
};

/// The filled columns that are linked to one of them, which is taken out.
std::set<Column> TakePart(std::set<Column>& open, const Oracle& oracle)
{
  std::set<Column> part;
  std::vector<Column> front = { *open.begin() };
  while (!front.empty())
  {
    const Column column = front.back();
    front.pop_back();
    if (open.erase(column) > 0)
    {
      part.insert(column);
      for (const Column& neighbour : Oracle::Neighbours(column))
      {
        if (oracle.IsLinked(column, neighbour))
        {
          front.push_back(neighbour);
        }
      }
    }
  }
  return part;
}

void CheckLattice(int n, Patches::Random& random)
{
  const int size = 7 + random.Below(6);
  const double missing = 0.1 + 0.5 * random.Fraction();
  const Patches::Columns columns = Square(
    size, [&](int x, int y) { return x > 0 && y > 0 && x < size - 1 && y < size - 1 && random.Chance(missing); });
  Horizon horizon = OnSurface(columns, [&](double, double) { return 10.0 * random.Fraction(); });
  LinkCuts cuts(PlaneBox({ { 0, 0 }, { size, size } }));
  const double torn = n % 2 == 0 ? 0.0 : 0.15 * random.Fraction();
  for (std::int32_t place = 0; place < size * size; ++place)
  {
    if (random.Chance(torn))
    {
      cuts.CutEast({ place % size, place / size });
    }
    if (random.Chance(torn))
    {
      cuts.CutNorth({ place % size, place / size });
    }
  }
  HoleFillingOptions options = AllHoles(FillMethod(n % 3 == 0), n % 5 == 0 ? 0.25 : n % 5 == 1 ? 8.0 : 1.0);
  options.RimWidth = 1 + n % 4;
  const FilledColumns filled = Fill(horizon, options, &cuts);
  std::map<Column, double> heights;
  std::set<Column> open;
  for (std::size_t c = 0; c < filled.Column.size(); ++c)
  {
    heights[{ filled.Column[c].X, filled.Column[c].Y }] = filled.Height[c];
    open.insert({ filled.Column[c].X, filled.Column[c].Y });
  }
  while (!open.empty())
  {
    Oracle oracle(horizon, cuts, options);
    for (const auto& [column, height] : oracle.Fill(TakePart(open, oracle)))
    {
      const auto found = heights.find(column);
      if (found != heights.end() && !oracle.Unsure && !CHECK(std::abs(found->second - height) < 1e-6))
      {
        std::cerr << "lattice " << n << ", column " << column.first << ' ' << column.second << ": " << found->second
                  << " is not " << height << '\n';
        return;
      }
      CHECK(found == heights.end() || std::isfinite(found->second));
    }
  }
}
}

int TestHoleFillingOracle(int, char*[])
{
  Patches::Random random(17);
  for (int n = 0; n < 600; ++n)
  {
    CheckLattice(n, random);
  }
  return Check::Result();
}
