// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SealedModel.h"

#include "Arrangement.h"
#include "BlockHeights.h"
#include "BlockTree.h"
#include "Common/Base/DisjointSets.h"
#include "Common/Base/Errors.h"
#include "Common/Horizon/PlaceText.h"
#include "SealedComplex.h"
#include "SealedImprover.h"
#include "Sheets.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr double SmallestSealedAngle = 15.0; // degrees

/// The sheets of a model by what they are.
class ModelSheets
{
public:
  ModelSheets(SealingInput& input, const SealingOptions& options, const Monitor& monitor)
    : Input(input)
    , Options(options)
    , Tree(input.Faults)
    , Box(input.Box())
    , Corners(input.Corners())
    , Column(input.Step.maxCoeff())
  {
    HorizonBlocks found = FindBlockHeights(input, options, monitor.Step(0.0, 0.3));
    this->Blocks = std::move(found.Blocks);
    this->Accounts = std::move(found.Accounts);
    this->Steps = std::move(found.Steps);
    constexpr double notThere = std::numeric_limits<double>::quiet_NaN();
    const auto step = [&]()
    {
      const double sheet = 0.7 / double(this->Blocks.size() + input.Faults.size());
      const double done = 0.3 + sheet * double(this->Sheets.size());
      return monitor.Step(done, done + sheet);
    };
    for (const BlockHeights& block : this->Blocks)
    {
      SheetHeights heights;
      heights.Origin = input.Step.array() * Eigen::Array2d(block.Window.Least.X, block.Window.Least.Y);
      heights.Step = input.Step;
      heights.Width = int(block.Window.Width());
      for (std::size_t node = 0; node < block.Heights.size(); ++node)
      {
        heights.Heights.push_back((block.Nodes[node] & IsMeshed) != 0 ? block.Heights[node] : notThere);
      }
      this->AddSheet(std::move(heights), options.MaximumError, step());
    }
    this->FirstFault = this->Sheets.size();
    for (const SealingFault& fault : input.Faults)
    {
      this->SheetsOfFaults.push_back(fault.PartOf ? this->SheetsOfFaults[*fault.PartOf] : this->Sheets.size());
      if (fault.PartOf)
      {
        continue;
      }
      this->AddSheet(this->HeightsOf(fault.Plate), options.FaultError, step());
    }
    this->AddWalls();
    this->FirstRibbon = this->Sheets.size();
    for (std::size_t fault = 0; fault < input.Faults.size(); ++fault)
    {
      if (!input.Faults[fault].PartOf)
      {
        this->AddRibbons(fault);
      }
    }
  }

  std::vector<std::pair<int, int>> Pairs() const
  {
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t a = 0; a < this->Sheets.size(); ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        if (this->CanMeet(b, a))
        {
          pairs.emplace_back(int(b), int(a));
        }
      }
    }
    return pairs;
  }

  std::int32_t SurfaceOf(std::int32_t sheet) const
  {
    const auto number = std::size_t(sheet);
    return number < this->FirstFault ? std::int32_t(this->Blocks[number].Horizon)
                                     : std::int32_t(number - this->FirstFault + this->Input.Horizons.size());
  }

  std::vector<SealedGuess> Guessed() const
  {
    std::vector<SealedGuess> guessed;
    for (const BlockHeights& block : this->Blocks)
    {
      if (block.IsGuessed && block.IsInBox)
      {
        guessed.push_back({ block.Horizon, block.Sides });
      }
    }
    return guessed;
  }

  std::vector<BlockSides> BlocksOfLabels() const
  {
    std::vector<BlockSides> blocks(this->Numbers.size());
    for (const auto& [sides, number] : this->Numbers)
    {
      blocks[std::size_t(number)] = sides;
    }
    return blocks;
  }

  VertexSource SourceOf(const Eigen::Vector3d& place, std::size_t sheet) const
  {
    if (sheet >= this->FirstWall)
    {
      return VertexSource::Picks;
    }
    if (sheet >= this->FirstFault)
    {
      const FaultPlate& plate = this->FaultOf(sheet).Plate;
      const FaultPlace at = plate.ToPlace(place);
      return plate.Contains(at.S, at.Z) ? VertexSource::Picks : VertexSource::Continued;
    }
    constexpr int near = 2; // columns
    const BlockHeights& block = this->Blocks[sheet];
    const Eigen::Vector2d column = (place.head<2>().array() / this->Input.Step.array()).round();
    return block.HasPickNear({ std::int32_t(column.x()), std::int32_t(column.y()) }, near) ? VertexSource::Picks
      : block.IsGuessed                                                                    ? VertexSource::OtherHorizon
                                                                                           : VertexSource::Continued;
  }

  std::int32_t NumberOf(const BlockSides& sides)
  {
    return this->Numbers.try_emplace(sides, std::int32_t(this->Numbers.size())).first->second;
  }

  /// Labels are blocks times layers.
  std::size_t NumberOfLayers() const { return this->Input.Horizons.size() + 1; }

  void Shake(unsigned round)
  {
    constexpr double part = 1e-3; // of a column
    this->Shaken = this->Sheets;
    SeismicHorizons::Shake(this->Shaken, part * this->Column, round);
    this->Locators.clear();
    for (std::size_t sheet = 0; sheet < this->FirstWall; ++sheet)
    {
      this->Locators.emplace_back(this->Shaken[sheet]);
    }
  }

  bool IsBeyondTips(const SealedComplex& complex, const LabelledTriangle& triangle) const
  {
    const auto sheet = std::size_t(triangle.Sheet);
    if (sheet < this->FirstFault || sheet >= this->FirstWall || triangle.Labels[0] == OutsideLabel ||
      triangle.Labels[1] == OutsideLabel)
    {
      return false;
    }
    const SealingFault& fault = this->FaultOf(sheet);
    return fault.IsBeyondTips(fault.Plate.ToPlace(CentreOf(complex.Vertices, triangle.Corners)));
  }

  SealedLabel LabelAt(const Eigen::Vector3d& place, std::int32_t sheet, int side)
  {
    const auto own = std::size_t(sheet);
    if (own >= this->FirstRibbon || this->IsOutside(place, own, side))
    {
      return OutsideLabel;
    }
    BlockSides known(this->Input.Faults.size(), 0);
    const auto isHanging = [&](std::size_t fault)
    {
      if (known[fault] == 0)
      {
        const std::size_t number = this->SheetsOfFaults[fault];
        known[fault] = (number == own ? side == 0 : this->HeightOver(number, place) > 0.0) ? 1 : -1;
      }
      return known[fault] == 1;
    };
    const auto isBelow = [&](std::size_t horizon)
    {
      const std::size_t number = this->FindBlock(horizon, this->Tree.FindAt(horizon, isHanging));
      return number == own ? side == 1 : this->HeightOver(number, place) < 0.0;
    };
    const BlockSides sides = this->Tree.Find(isHanging, isBelow);
    std::size_t layer = 0;
    while (layer < this->Input.Horizons.size() && isBelow(layer))
    {
      ++layer;
    }
    return this->NumberOf(sides) * SealedLabel(this->NumberOfLayers()) + SealedLabel(layer);
  }

  std::vector<PickAccount> Accounts;
  std::vector<TipStep> Steps;
  std::vector<Sheet> Shaken;
  std::vector<SheetShape> Shapes;

private:
  static constexpr double partOfError = 0.5;

  /// Walls, base and top, a column larger than the model. The normals of walls point inside.
  void AddWalls()
  {
    constexpr double mostSquares = 24.0, leastSquare = 8.0; // along the longest side; in columns
    const double square = std::max(leastSquare * this->Column, this->Box.sizes().maxCoeff() / mostSquares);
    const Eigen::Vector3d beyond = Eigen::Vector3d::Constant(this->Column);
    const Eigen::Vector3d least = this->Box.min() - beyond, size = this->Box.sizes() + 2.0 * beyond;
    const auto add = [&](const Eigen::Vector3d& corner, const Eigen::Vector3d& along, const Eigen::Vector3d& up)
    {
      this->Sheets.push_back(MakePlaneSheet(corner, along, up, square));
      this->Shapes.push_back({ SheetHeights(), 0.0, this->Sheets.back().Axes });
    };
    this->FirstWall = this->Sheets.size();
    for (std::size_t n = 0; n < this->Corners.size(); ++n)
    {
      const Eigen::Vector2d from = this->Corners[n], way = this->Corners[(n + 1) % this->Corners.size()] - from;
      const Eigen::Vector2d margin = this->Column * way.normalized();
      const Eigen::Vector2d first = from - margin, length = way + 2.0 * margin;
      add({ first.x(), first.y(), least.z() }, { length.x(), length.y(), 0.0 }, { 0.0, 0.0, size.z() });
    }
    this->FirstLimit = this->Sheets.size();
    for (const double level : { this->Box.min().z(), this->Box.max().z() })
    {
      add({ least.x(), least.y(), level }, { size.x(), 0.0, 0.0 }, { 0.0, size.y(), 0.0 });
    }
  }

  /// Planes across a fault that cut it along its tip line, and bound nothing themselves.
  void AddRibbons(std::size_t number)
  {
    const SealingFault& fault = this->Input.Faults[number];
    const FaultPlate& plate = fault.Plate;
    const Eigen::Vector3d across(plate.AcrossOnMap().x(), plate.AcrossOnMap().y(), 0.0);
    constexpr int steps = 8;
    constexpr double beyond = 0.5; // columns
    const double wider = 1.00023 + 0.00017 * double(number); // so that they do not lie on each other, or on edges
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& corner : fault.TipLoop)
    {
      middle += corner / double(fault.TipLoop.size());
    }
    for (std::size_t n = 0; n < fault.TipLoop.size(); ++n)
    {
      const Eigen::Vector2d from = middle + wider * (fault.TipLoop[n] - middle);
      const Eigen::Vector2d way = wider * (fault.TipLoop[(n + 1) % fault.TipLoop.size()] - fault.TipLoop[n]);
      std::array<double, 2> reach = { std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity() };
      for (int step = 0; step <= steps; ++step)
      {
        const Eigen::Vector2d at = from + way * step / steps;
        const double offset = plate.Offset(at.x(), at.y());
        reach = { std::min(reach[0], offset - 2.0 * this->Column), std::max(reach[1], offset + 2.0 * this->Column) };
      }
      const Eigen::Vector2d margin = beyond * this->Column * way.normalized(), first = from - margin,
                            last = from + way + margin;
      const Eigen::Vector3d corner = plate.ToWorld({ first.x(), reach[0], first.y() });
      const Eigen::Vector3d along = plate.ToWorld({ last.x(), reach[0], last.y() }) - corner;
      this->Sheets.push_back(MakePlaneSheet(corner, along, (reach[1] - reach[0]) * across, along.norm()));
      this->Shapes.push_back({ SheetHeights(), 0.0, this->Sheets.back().Axes });
      this->FaultsOfRibbons.push_back(number);
    }
  }

  /// Just before a place of a sheet (side 0), or behind.
  bool IsOutside(const Eigen::Vector3d& place, std::size_t own, int side) const
  {
    for (std::size_t limit = this->FirstLimit; limit < this->FirstRibbon; ++limit)
    {
      const bool isTop = limit > this->FirstLimit;
      const double above = place.z() - this->Sheets[limit].Level();
      if (own == limit ? (side == 0) == isTop : isTop == (above > 0.0))
      {
        return true;
      }
    }
    const Eigen::Vector2d column = place.head<2>();
    if (own >= this->FirstWall && own < this->FirstLimit)
    {
      const std::size_t n = own - this->FirstWall;
      const Eigen::Vector2d way = this->Corners[(n + 1) % this->Corners.size()] - this->Corners[n];
      const double part = (column - this->Corners[n]).dot(way) / way.squaredNorm();
      if (part > 0.0 && part < 1.0)
      {
        return side == 1;
      }
    }
    return !IsInside(this->Corners, column);
  }

  void AddSheet(SheetHeights heights, double error, const Monitor& monitor)
  {
    this->Sheets.push_back(MeshSheet(heights, partOfError * error, monitor));
    const Eigen::Matrix3d axes = heights.Axes;
    this->Shapes.push_back({ std::move(heights), error, axes });
  }

  bool CanMeet(std::size_t a, std::size_t b) const // a < b
  {
    if (b >= this->FirstRibbon)
    {
      // What meets the fault, and the other ribbons of it.
      const std::size_t fault = this->FaultsOfRibbons[b - this->FirstRibbon];
      const std::size_t sheet = this->SheetsOfFaults[fault];
      return a >= this->FirstRibbon ? this->FaultsOfRibbons[a - this->FirstRibbon] == fault
                                    : a == sheet || this->CanMeet(std::min(a, sheet), std::max(a, sheet));
    }
    if (b >= this->FirstWall)
    {
      return a < this->FirstLimit; // Top and base do not meet.
    }
    if (b < this->FirstFault)
    {
      return this->Blocks[a].Horizon != this->Blocks[b].Horizon &&
        BlockTree::AreTogether(this->Blocks[a].Sides, this->Blocks[b].Sides);
    }
    for (std::size_t fault = 0; fault < this->SheetsOfFaults.size(); ++fault)
    {
      if (this->SheetsOfFaults[fault] == b && this->CanReach(a, fault))
      {
        return true;
      }
    }
    return false;
  }

  /// Whether a fault may meet the sheet of a horizon or another fault.
  bool CanReach(std::size_t sheet, std::size_t fault) const
  {
    if (sheet < this->FirstFault)
    {
      return this->Blocks[sheet].Sides[fault] != 0 ||
        this->Input.Faults[fault].EndsBelow == this->Blocks[sheet].Horizon;
    }
    for (std::size_t other = 0; other < this->SheetsOfFaults.size(); ++other)
    {
      if (this->SheetsOfFaults[other] == sheet && this->Tree.CanMeet(other, fault))
      {
        return true;
      }
    }
    return false;
  }

  const SealingFault& FaultOf(std::size_t sheet) const
  {
    const auto fault = std::find(this->SheetsOfFaults.begin(), this->SheetsOfFaults.end(), sheet);
    return this->Input.Faults[std::size_t(fault - this->SheetsOfFaults.begin())];
  }

  std::size_t FindBlock(std::size_t horizon, const BlockSides& sides) const
  {
    const auto found = std::find_if(this->Blocks.begin(), this->Blocks.end(),
      [&](const BlockHeights& block) { return block.Horizon == horizon && block.Sides == sides; });
    assert(found != this->Blocks.end());
    return std::size_t(found - this->Blocks.begin());
  }

  double HeightOver(std::size_t sheet, const Eigen::Vector3d& place) const
  {
    if (const std::optional<double> height = this->Locators[sheet].HeightAbove(place))
    {
      return *height;
    }
    if (sheet >= this->FirstFault)
    {
      const FaultPlate& plate = this->FaultOf(sheet).Plate;
      return plate.Distance(plate.ToPlace(place));
    }
    // Far from its block, a horizon only has to be above or below.
    const Eigen::Vector2d column = (place.head<2>().array() / this->Input.Step.array()).round();
    return place.z() - this->Blocks[sheet].HeightNear({ std::int32_t(column.x()), std::int32_t(column.y()) });
  }

  SheetHeights HeightsOf(const FaultPlate& plate) const
  {
    SheetHeights heights;
    heights.Axes << plate.AlongOnMap().x(), plate.AlongOnMap().y(), 0.0, 0.0, 0.0, 1.0, plate.AcrossOnMap().x(),
      plate.AcrossOnMap().y(), 0.0;
    Eigen::AlignedBox2d box;
    for (int corner = 0; corner < 8; ++corner)
    {
      box.extend((heights.Axes * this->Box.corner(Eigen::AlignedBox3d::CornerType(corner))).head<2>());
    }
    const double margin = 2.0 * this->Column;
    box.min() -= Eigen::Vector2d::Constant(margin);
    box.max() += Eigen::Vector2d::Constant(margin);
    constexpr double levels = 64.0;
    const Eigen::Vector2i nodes(int(std::ceil(box.sizes().x() / this->Column)), int(levels));
    heights.Origin = box.min();
    heights.Step = box.sizes().array() / nodes.cast<double>().array();
    heights.Width = nodes.x() + 1;
    heights.Heights.assign(std::size_t(heights.Width) * std::size_t(nodes.y() + 1), 0.0);
    for (std::size_t node = 0; node < heights.Heights.size(); ++node)
    {
      const FaultPlace place = plate.ToPlace(heights.At(node));
      heights.Heights[node] = -plate.Distance(place);
    }
    return heights;
  }

  const SealingInput& Input;
  const SealingOptions& Options;
  BlockTree Tree;
  Eigen::AlignedBox3d Box;
  std::vector<Eigen::Vector2d> Corners; // of walls
  double Column;
  std::vector<BlockHeights> Blocks;
  std::vector<Sheet> Sheets; // of blocks, faults, walls, base and top, ribbons
  std::vector<std::size_t> SheetsOfFaults; // Parts of one fault share it.
  std::size_t FirstFault = 0;
  std::size_t FirstWall = 0;
  std::size_t FirstLimit = 0; // base and top
  std::size_t FirstRibbon = 0;
  std::vector<std::size_t> FaultsOfRibbons;
  std::vector<SheetLocator> Locators;
  std::map<BlockSides, std::int32_t> Numbers;
};

SealedComplex CutAndLabel(ModelSheets& sheets, const Monitor& monitor)
{
  constexpr unsigned mostRounds = 8;
  for (unsigned round = 0;; ++round)
  {
    sheets.Shake(round);
    try
    {
      return KeepDifferent(
        Arrange(sheets.Shaken, sheets.Pairs(), monitor.Step(0.0, 0.6)),
        [&](const Eigen::Vector3d& place, std::int32_t sheet, int side) { return sheets.LabelAt(place, sheet, side); },
        monitor.Step(0.6, 1.0));
    }
    catch (const Undecided& undecided)
    {
      if (round + 1 == mostRounds)
      {
        throw InputError("surfaces that touch at " + PlaceText(undecided.Place) + ", expected them to cross");
      }
    }
  }
}

/// Throws InputError for a place of a horizon that is not between its layers: another one crosses it between columns.
void RequireOrder(const SealedComplex& complex, const ModelSheets& sheets, const SealingInput& input)
{
  const auto layers = SealedLabel(sheets.NumberOfLayers());
  for (const LabelledTriangle& triangle : complex.Triangles)
  {
    const auto surface = std::size_t(sheets.SurfaceOf(triangle.Sheet));
    if (surface < input.Horizons.size() &&
      (triangle.Labels[0] % layers != SealedLabel(surface) || triangle.Labels[1] % layers != SealedLabel(surface) + 1))
    {
      throw InputError("horizon " + input.Horizons[surface].Name + " that another one crosses at " +
        PlaceText(complex.Vertices[std::size_t(triangle.Corners[0])]) + ", expected horizons in order");
    }
  }
}

/// Beyond the tips of a fault, what is alike on both sides becomes one, in a block that the fault does not bound.
SealedComplex OpenBeyondTips(SealedComplex complex, ModelSheets& sheets)
{
  const auto layers = SealedLabel(sheets.NumberOfLayers());
  std::vector<BlockSides> blocks = sheets.BlocksOfLabels(); // by label
  std::vector<BlockSides> sides;
  for (std::size_t label = 0; label < blocks.size() * std::size_t(layers); ++label)
  {
    sides.push_back(blocks[label / std::size_t(layers)]);
  }
  DisjointSets same(sides.size());
  const auto isOpen = [layers](const LabelledTriangle& triangle)
  { return triangle.IsBeyondTips && triangle.Labels[0] % layers == triangle.Labels[1] % layers; };
  for (LabelledTriangle& triangle : complex.Triangles)
  {
    triangle.IsBeyondTips = sheets.IsBeyondTips(complex, triangle);
    if (isOpen(triangle))
    {
      same.Join(triangle.Labels[0], triangle.Labels[1]);
    }
  }
  complex.Triangles.erase(
    std::remove_if(complex.Triangles.begin(), complex.Triangles.end(), isOpen), complex.Triangles.end());
  for (std::size_t label = 0; label < sides.size(); ++label)
  {
    BlockSides& together = sides[std::size_t(same.Find(SealedLabel(label)))];
    for (std::size_t fault = 0; fault < together.size(); ++fault)
    {
      together[fault] = together[fault] == blocks[label / std::size_t(layers)][fault] ? together[fault] : 0;
    }
  }
  for (LabelledTriangle& triangle : complex.Triangles)
  {
    for (SealedLabel& label : triangle.Labels)
    {
      label =
        label == OutsideLabel ? label : sheets.NumberOf(sides[std::size_t(same.Find(label))]) * layers + label % layers;
    }
  }
  DropUnused(complex);
  return complex;
}

std::vector<SealedSurface> NameSurfaces(const SealingInput& input)
{
  std::vector<SealedSurface> surfaces;
  for (const SealingHorizon& horizon : input.Horizons)
  {
    surfaces.push_back({ horizon.Name, SealedSurfaceType::Horizon });
  }
  for (const SealingFault& fault : input.Faults)
  {
    if (!fault.PartOf)
    {
      surfaces.push_back({ fault.Plate.Name(), SealedSurfaceType::Fault });
    }
  }
  constexpr std::array<const char*, 4> ofBox = { "West", "North", "East", "South" };
  for (std::size_t wall = 0; wall < input.Corners().size(); ++wall)
  {
    surfaces.push_back(
      { input.Outline.empty() ? ofBox[wall] : "Wall " + std::to_string(wall + 1), SealedSurfaceType::Wall });
  }
  surfaces.push_back({ "Model base", SealedSurfaceType::Limit });
  surfaces.push_back({ "Model top", SealedSurfaceType::Limit });
  return surfaces;
}

/// The least height of a triangle.
double ThicknessOf(const SealedComplex& complex, const LabelledTriangle& triangle)
{
  const auto at = [&](std::size_t corner) { return complex.Vertices[std::size_t(triangle.Corners[corner])]; };
  const Eigen::Vector3d u = at(1) - at(0), v = at(2) - at(1), w = at(0) - at(2);
  return u.cross(v).norm() / std::max({ u.norm(), v.norm(), w.norm() });
}

/// Throws InputError if bodies leave a gap, or overlap.
void RequireFull(const SealingInput& input, const std::vector<SealedBody>& bodies)
{
  const std::vector<Eigen::Vector2d> corners = input.Corners();
  double area = 0.0, volume = 0.0;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    const Eigen::Vector2d &a = corners[n], &b = corners[(n + 1) % corners.size()];
    area += 0.5 * (b.x() * a.y() - a.x() * b.y());
  }
  for (const SealedBody& body : bodies)
  {
    volume += body.Volume;
  }
  constexpr double rounding = 1e-9;
  const double whole = area * (input.Top - input.Base);
  if (!(std::abs(volume - whole) <= rounding * whole))
  {
    throw InputError("bodies of a volume of " + std::to_string(volume) + " in walls around " + std::to_string(whole) +
      ", expected these to be full");
  }
}

/// Adds triangles and bodies. Strips beyond tips are steps if they are higher than gaps that may be closed.
void DescribeModel(
  const SealedComplex& complex, const ModelSheets& sheets, double thinnest, double gap, SealedModel& model)
{
  const ComplexBodies bodies = FindBodies(complex);
  const auto layers = std::int32_t(sheets.NumberOfLayers());
  model.LeastAngle = bodies.LeastAngle;
  model.Sources.assign(complex.Vertices.size(), VertexSource::Picks);
  for (std::size_t n = 0; n < complex.Triangles.size(); ++n)
  {
    const LabelledTriangle& triangle = complex.Triangles[n];
    model.Triangles.push_back({ triangle.Corners, sheets.SurfaceOf(triangle.Sheet), bodies.OfTriangles[n] });
    const double thickness = ThicknessOf(complex, triangle);
    model.Slivers += thickness < thinnest ? 1 : 0;
    constexpr double steps = 2.0; // gaps; just beyond tips strips may be a little higher than one
    const bool isStep = triangle.IsBeyondTips && thickness > steps * MostGap * gap;
    model.BeyondTips.insert(model.BeyondTips.end(), isStep ? 1 : 0, sheets.SurfaceOf(triangle.Sheet));
    for (const std::int32_t corner : triangle.Corners)
    {
      VertexSource& source = model.Sources[std::size_t(corner)];
      source = std::max(source, sheets.SourceOf(complex.Vertices[std::size_t(corner)], std::size_t(triangle.Sheet)));
    }
  }
  std::sort(model.BeyondTips.begin(), model.BeyondTips.end());
  model.BeyondTips.erase(std::unique(model.BeyondTips.begin(), model.BeyondTips.end()), model.BeyondTips.end());
  std::vector<std::int32_t> order(bodies.Labels.size()), numbers(bodies.Labels.size());
  std::iota(order.begin(), order.end(), 0);
  const auto placeOf = [&](std::int32_t body)
  { return std::make_pair(bodies.Labels[std::size_t(body)] % layers, bodies.Labels[std::size_t(body)]); };
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) { return placeOf(a) < placeOf(b); });
  for (const std::int32_t body : order)
  {
    const std::int32_t label = bodies.Labels[std::size_t(body)];
    numbers[std::size_t(body)] = std::int32_t(model.Bodies.size());
    model.Bodies.push_back(
      { std::size_t(label % layers), std::size_t(label / layers), bodies.Volumes[std::size_t(body)] });
  }
  for (SealedTriangle& triangle : model.Triangles)
  {
    for (std::int32_t& body : triangle.Body)
    {
      body = body < 0 ? body : numbers[std::size_t(body)];
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
bool IsInside(const std::vector<Eigen::Vector2d>& corners, const Eigen::Vector2d& place)
{
  bool isInside = false;
  for (std::size_t n = 0; n < corners.size(); ++n)
  {
    const Eigen::Vector2d &a = corners[n], &b = corners[(n + 1) % corners.size()];
    if ((a.y() > place.y()) != (b.y() > place.y()) &&
      place.x() < a.x() + (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y()))
    {
      isInside = !isInside;
    }
  }
  return isInside;
}

//----------------------------------------------------------------------------------------------------------------------
bool SealingFault::IsBeyondTips(const FaultPlace& place) const
{
  return !this->TipLoop.empty() && !IsInside(this->TipLoop, { place.S, place.Z });
}

//----------------------------------------------------------------------------------------------------------------------
SealedModel SealModel(SealingInput input, const SealingOptions& options, const Monitor& monitor)
{
  ModelSheets sheets(input, options, monitor.Step(0.0, 0.4));
  const double column = input.Step.maxCoeff();
  const ImproverOptions improver = { std::min(options.MaximumError, options.FaultError), SmallestSealedAngle, column };
  SealedComplex cut = CutAndLabel(sheets, monitor.Step(0.4, 0.7));
  RequireOrder(cut, sheets, input);
  const SealedComplex complex =
    Improve(OpenBeyondTips(std::move(cut), sheets), sheets.Shapes, improver, monitor.Step(0.7, 1.0));
  SealedModel model;
  model.Surfaces = NameSurfaces(input);
  std::transform(input.Faults.begin(), input.Faults.end(), std::back_inserter(model.FaultNames),
    [](const SealingFault& fault) { return fault.Plate.Name(); });
  model.Vertices = complex.Vertices;
  constexpr double thinnest = 1e-3; // columns
  DescribeModel(complex, sheets, thinnest * column, improver.LineError, model);
  RequireFull(input, model.Bodies);
  model.Blocks = sheets.BlocksOfLabels();
  model.Guessed = sheets.Guessed();
  model.Accounts = sheets.Accounts;
  model.Steps = sheets.Steps;
  model.LargestError = MeasureLargestError(complex, sheets.Shapes);
  return model;
}
}
