// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonStackStage.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Parameters.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Filters/Algorithms/Layers/OrderedStack.h"
#include "Filters/Marshalling/HeightUnit.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "HorizonStack.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr std::array<const char*, 4> PolicyNames = { "Mean", "UpperWins", "LowerWins", "Stop" };

/// The text has one policy per layer, from the top.
std::vector<CrossingPolicy> ParsePolicies(const std::string& text, std::size_t layers)
{
  std::vector<CrossingPolicy> policies;
  std::istringstream words(text);
  for (std::string word; words >> word;)
  {
    const auto found = std::find(PolicyNames.begin(), PolicyNames.end(), word);
    if (found == PolicyNames.end())
    {
      throw InputError("crossings \"" + word + "\", expected Mean, UpperWins, LowerWins or Stop");
    }
    policies.push_back(static_cast<CrossingPolicy>(found - PolicyNames.begin()));
  }
  if (!policies.empty() && policies.size() != layers)
  {
    throw InputError("crossings of " + std::to_string(policies.size()) + " layers, expected " + std::to_string(layers) +
      ", from the uppermost on");
  }
  return policies;
}
}

//------------------------------------------------------------------------------
vtkHorizonStackStage::~vtkHorizonStackStage()
{
  this->SetCrossingsByLayer(nullptr);
}

//------------------------------------------------------------------------------
HorizonStack vtkHorizonStackStage::ReadStack(vtkInformationVector* inputs, std::string& subject, const Monitor& monitor)
{
  std::vector<HorizonLeaf> leaves;
  std::vector<std::string> names;
  for (int n = 0; n < inputs->GetNumberOfInformationObjects(); ++n)
  {
    for (HorizonLeaf& leaf : ListHorizons(vtkDataObject::GetData(inputs, n), {}))
    {
      if (leaf.Input->GetNumberOfPoints() > 0)
      {
        names.push_back(leaf.Name.empty() ? "Surface " + std::to_string(names.size() + 1) : leaf.Name);
        leaves.push_back(std::move(leaf));
      }
    }
  }
  names = MakeDistinct(std::move(names));
  HorizonStack stack;
  for (std::size_t n = 0; n < leaves.size(); ++n)
  {
    subject = names[n];
    RunPart(this, this->GetInvalidHorizons() == LeaveOut, subject, {},
      [&]()
      {
        CheckArraySizes(leaves[n].Input);
        const vtkSmartPointer<vtkPolyData> points = WithoutHiddenPoints(leaves[n].Input);
        if (points->GetNumberOfPoints() > 0)
        {
          stack.Add(names[n], points);
        }
      });
    monitor.Progress(0.5 * double(n + 1) / double(leaves.size()));
  }
  subject.clear();
  if (stack.Size() < 2)
  {
    throw InputError(
      (stack.Size() == 0 ? "no horizon" : "one horizon") + std::string(" with points, expected at least 2"));
  }
  stack.PlaceTogether();
  if (!stack.GetDoubt().empty())
  {
    vtkWarningMacro(<< stack.GetDoubt());
  }
  monitor.Progress(0.8);
  const CrossingOptions crossings = this->MakeCrossings(stack);
  if (this->Order == ByHeight)
  {
    stack.Reorder(OrderByHeight(stack.Views(), crossings));
  }
  return stack;
}

//------------------------------------------------------------------------------
CrossingOptions vtkHorizonStackStage::MakeCrossings(const HorizonStack& stack) const
{
  CrossingOptions crossings;
  crossings.Names = stack.Names();
  crossings.HeightsGrowDownwards = stack.HeightsGrowDownwards();
  crossings.Policies = ParsePolicies(this->CrossingsByLayer ? this->CrossingsByLayer : "", stack.Size() - 1);
  if (crossings.Policies.empty())
  {
    crossings.Policies = { static_cast<CrossingPolicy>(this->Crossings) };
  }
  CheckAtLeast("minimum thickness", this->MinimumThickness, 0.0, "");
  crossings.MinimumThickness = this->IndicesOf(this->MinimumThickness, stack);
  return crossings;
}

//------------------------------------------------------------------------------
int vtkHorizonStackStage::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkHorizonStackStage::RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // The executive makes the outputs.
}

//------------------------------------------------------------------------------
// Each process reads all horizons, so that all have the same blocks; the first does the work.
int vtkHorizonStackStage::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  AskForWhole(inputVector[0]);
  return 1;
}

//------------------------------------------------------------------------------
double vtkHorizonStackStage::IndicesOf(double height, const HorizonStack& stack) const
{
  const auto unit =
    this->HeightUnit == World ? SeismicHorizons::HeightUnit::World : SeismicHorizons::HeightUnit::Lattice;
  return height * IndicesPerUnit(unit, {}, {}, stack.CommonLattice());
}
