// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Despiking, faults and hole filling one after the other, on small horizons of odd shapes, with parameters drawn at
// random, some of them out of range: one error and nothing, or a result that is right as far as can be told. It has to
// come at once, however large a number is.

#include "HorizonFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonDespiking.h"
#include "vtkHorizonFaults.h"
#include "vtkHorizonHoleFilling.h"

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int Runs = 400;

class Draw
{
public:
  explicit Draw(unsigned int seed)
    : Engine(seed)
  {
  }

  int Below(int bound) { return int(this->Engine() % unsigned(bound)); }

  /// Mostly a usual one.
  double Number()
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double odd[] = { std::nan(""), infinity, -infinity, -1.0, -0.0, 0.0, 1e300, 1e-300, 1e12 };
    return this->Below(3) == 0 ? odd[this->Below(9)] : 0.01 * this->Below(1000);
  }

  int Whole()
  {
    const int odd[] = { 0, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), 1000, 64, 65 };
    return this->Below(4) == 0 ? odd[this->Below(7)] : 1 + this->Below(8);
  }

private:
  std::mt19937 Engine; // its numbers are the same everywhere
};

double Level(int, int)
{
  return 20.0;
}

double Torn(int i, int j)
{
  return (i > 4 ? 31.0 : 20.0) + 0.125 * j;
}

double Spiky(int i, int j)
{
  return (3 * i + 5 * j) % 11 == 0 ? 60.0 : 20.0;
}

double Huge(int i, int j)
{
  return (i + j) % 2 == 0 ? 1e15 : -1e15;
}

std::vector<std::string> DrawPicture(Draw& draw)
{
  const int width = 1 + draw.Below(12);
  const int height = draw.Below(4) == 0 ? 1 : 1 + draw.Below(12);
  const int kind = draw.Below(5);
  std::vector<std::string> rows = HorizonFixtures::Rectangle(width, height);
  for (int j = 0; j < height; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const bool isInside = i > 0 && j > 0 && i + 1 < width && j + 1 < height;
      const bool isGap = kind == 1 ? (i + j) % 2 != 0 : kind == 2 ? isInside : kind == 3 && draw.Below(2) == 0;
      rows[std::size_t(j)][std::size_t(i)] = isGap && i + j > 0 ? '.' : '#';
    }
  }
  return rows;
}

vtkSmartPointer<vtkPolyData> DrawHorizon(Draw& draw)
{
  double (*const heights[])(int, int) = { Level, Torn, Spiky, Huge, HorizonFixtures::FoldedHeight };
  const auto survey = draw.Below(2) == 0 ? HorizonFixtures::UnitSurvey() : HorizonFixtures::RotatedSurvey();
  return HorizonFixtures::FromPicture(DrawPicture(draw), 7, survey, heights[draw.Below(5)]);
}

using Place = std::pair<double, double>;

/// The height at each place. False when two points stand at one, or one is not finite.
bool ListHeights(vtkPolyData* horizon, std::map<Place, double>& heights)
{
  bool isRight = true;
  for (vtkIdType point = 0; point < horizon->GetNumberOfPoints(); ++point)
  {
    const double* const at = horizon->GetPoint(point);
    isRight = isRight && std::isfinite(at[0] + at[1] + at[2]);
    isRight = heights.emplace(Place(std::round(1e3 * at[0]), std::round(1e3 * at[1])), at[2]).second && isRight;
  }
  return isRight;
}

/// Whether all points of a horizon are in another one, with the same heights.
bool Contains(vtkPolyData* whole, vtkPolyData* part)
{
  std::map<Place, double> ofWhole;
  std::map<Place, double> ofPart;
  bool isRight = ListHeights(whole, ofWhole) && ListHeights(part, ofPart);
  for (const auto& [place, height] : ofPart)
  {
    const auto found = ofWhole.find(place);
    isRight = isRight && found != ofWhole.end() && found->second == height;
  }
  return isRight;
}

/// Nothing but one error, or no error: whether there is a result.
template <typename Stage>
vtkPolyData* Run(Stage* stage, vtkPolyData* input, const std::string& name)
{
  stage->SetInputData(input);
  const HorizonFixtures::Errors errors(stage);
  stage->Update();
  const bool isRefused = errors.Count() > 0;
  const bool isClear = errors.Count() <= 1 && (!isRefused || errors.FirstContains("expected"));
  const bool isSound = isClear && (!isRefused || stage->GetPolyDataOutput()->GetNumberOfPoints() == 0);
  if (!CHECK(isSound))
  {
    std::cerr << name << ": " << errors.First() << '\n';
  }
  return isRefused ? nullptr : stage->GetPolyDataOutput();
}

vtkSmartPointer<vtkPolyData> Despike(vtkPolyData* input, Draw& draw)
{
  vtkNew<vtkHorizonDespiking> stage;
  stage->SetAction(draw.Below(2));
  stage->SetThreshold(draw.Number());
  stage->SetNeighborhoodRadius(draw.Whole());
  stage->SetSpurWidth(draw.Whole());
  vtkPolyData* const output = Run(stage.Get(), input, "despiking");
  CHECK(!output || Contains(input, output));
  CHECK(!output || stage->GetAction() == 0 || output->GetNumberOfPoints() == input->GetNumberOfPoints());
  return output ? output : input;
}

vtkSmartPointer<vtkPolyData> Cut(vtkPolyData* input, Draw& draw)
{
  vtkNew<vtkHorizonFaults> stage;
  stage->SetSmallestThrow(draw.Number());
  stage->SetNoise(draw.Number());
  stage->SetSmallestExtent(draw.Whole());
  stage->SetSmallestBranch(draw.Whole());
  stage->SetLargestGap(draw.Whole());
  vtkPolyData* const output = Run(stage.Get(), input, "faults");
  CHECK(!output || (Contains(output, input) && output->GetNumberOfPoints() == input->GetNumberOfPoints()));
  return output ? output : input;
}

void Fill(vtkPolyData* input, Draw& draw)
{
  vtkNew<vtkHorizonHoleFilling> stage;
  stage->SetLargestHoleSize(draw.Whole());
  stage->SetLargestHoleArea(draw.Below(2) == 0 ? 0.0 : draw.Number());
  stage->SetMethod(draw.Below(2));
  stage->SetRimSmoothing(draw.Number());
  stage->SetRimWidth(draw.Whole());
  stage->SetAttributes(draw.Below(2));
  vtkPolyData* const output = Run(stage.Get(), input, "hole filling");
  CHECK(!output || Contains(output, input));
  CHECK(!output || output->GetNumberOfPoints() == input->GetNumberOfPoints() + stage->GetNumberOfFilledPoints());
}
}

int TestHorizonPreparations(int, char*[])
{
  for (int run = 0; run < Runs; ++run)
  {
    const int failures = Check::Failures();
    Draw draw(static_cast<unsigned int>(run));
    const vtkSmartPointer<vtkPolyData> horizon = DrawHorizon(draw);
    Fill(Cut(Despike(horizon, draw), draw), draw);
    if (Check::Failures() != failures)
    {
      std::cerr << "run " << run << '\n';
    }
  }
  return Check::Result();
}
