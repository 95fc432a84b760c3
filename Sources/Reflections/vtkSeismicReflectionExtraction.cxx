// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSeismicReflectionExtraction.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/HorizonConversion.h"
#include "Common/VTK/HorizonTree.h"
#include "ReflectionStage.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <string>
#include <utility>

using namespace SeismicHorizons;

namespace
{
constexpr int GuidesPort = 1;
constexpr int LimitsPort = 2;

SeismicImage ReadImage(vtkImageData* given, vtkDataArray* amplitudes)
{
  SeismicImage image;
  std::copy_n(given->GetExtent(), image.Extent.size(), image.Extent.begin());
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(given->GetDirectionMatrix()->GetData());
  image.ToWorld.linear() = axes * Eigen::Vector3d(given->GetSpacing()).asDiagonal();
  image.ToWorld.translation() = Eigen::Vector3d(given->GetOrigin());
  image.Amplitudes = FromVTK(amplitudes);
  if (vtkUnsignedCharArray* const ghosts = given->GetPointGhostArray())
  {
    image.Ghosts = FromVTK(ghosts);
  }
  image.FieldData = FromVTK(given->GetFieldData());
  return image;
}

void AddLeaves(vtkDataObject* data, std::vector<NamedHorizon>& horizons)
{
  for (const HorizonLeaf& leaf : ListHorizons(data, {}))
  {
    horizons.push_back({ leaf.Name, FromVTK(leaf.Input) });
  }
}
}

struct vtkSeismicReflectionExtraction::Surfaces : FoundReflections
{
};

struct vtkSeismicReflectionExtraction::Kept
{
  using State = std::pair<const void*, vtkMTimeType>;

  std::vector<State> Inputs; // with all that is read, except for guides
  std::shared_ptr<JoinedReflections> Reflections;

  void Read(vtkObject* input, vtkMTimeType updated = 0)
  {
    this->Inputs.emplace_back(input, std::max(input->GetMTime(), updated));
  }
};

vtkStandardNewMacro(vtkSeismicReflectionExtraction);

//----------------------------------------------------------------------------------------------------------------------
vtkSeismicReflectionExtraction::vtkSeismicReflectionExtraction()
{
  this->SetNumberOfInputPorts(3);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

//----------------------------------------------------------------------------------------------------------------------
vtkSeismicReflectionExtraction::~vtkSeismicReflectionExtraction() = default;

//----------------------------------------------------------------------------------------------------------------------
int vtkSeismicReflectionExtraction::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port != 0)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), port == LimitsPort ? 1 : 0);
    AcceptHorizons(info);
    return 1;
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
ExtractionOptions vtkSeismicReflectionExtraction::MakeOptions() const
{
  ExtractionOptions options;
  options.PhaseRotation = this->PhaseRotation;
  options.Reflections.Polarity = static_cast<ReflectionPolarity>(this->Polarity);
  options.Reflections.Position = static_cast<ReflectionPosition>(this->Position);
  options.Reflections.Threshold =
    this->ThresholdType == Amplitude ? ThresholdKind::Amplitude : ThresholdKind::Percentile;
  options.Reflections.AmplitudeThreshold = this->AmplitudeThreshold;
  options.Reflections.AmplitudePercentile = this->AmplitudePercentile;
  options.Joining = this->Joining == Components ? SurfaceJoining::Components : SurfaceJoining::BestFirst;
  options.Connectivity = this->Connectivity == Four ? ColumnConnectivity::Four : ColumnConnectivity::Eight;
  options.LargestStep = this->LargestStep;
  options.SmallestCorrelation = this->SmallestCorrelation;
  options.SmallestContact = this->SmallestContact;
  options.SmallestSize = this->SmallestSize;
  options.LargestNumber = this->LargestNumber;
  options.Order = this->Order == Strength ? SurfaceOrder::Strength : SurfaceOrder::Size;
  options.Guidance.Tolerance = this->GuideTolerance;
  options.Guidance.GrowthCorrelation = this->GrowthCorrelation;
  options.Guidance.GrowthReach = this->GrowthReach;
  options.Guidance.LeastConfidence = this->LeastConfidence;
  options.Guidance.KeepOthers = this->KeepOthers;
  return options;
}

//----------------------------------------------------------------------------------------------------------------------
void vtkSeismicReflectionExtraction::CheckParameters()
{
  if (this->Joining != BestFirst && this->Joining != Components)
  {
    throw InputError("Joining Continuous of version 0.2, expected BestFirst with SmallestContact 0, which finds more");
  }
  CheckOptions(this->MakeOptions());
}

//----------------------------------------------------------------------------------------------------------------------
vtkImageData* vtkSeismicReflectionExtraction::GetCube()
{
  auto* const cube = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  if (!cube)
  {
    throw InputError("no input, expected an image");
  }
  return cube;
}

//----------------------------------------------------------------------------------------------------------------------
vtkDataArray* vtkSeismicReflectionExtraction::FindAmplitudes(vtkImageData* cube)
{
  vtkInformation* const choice = this->GetInputArrayInformation(0);
  const char* const given = choice->Get(vtkDataObject::FIELD_NAME());
  // ParaView passes "" before it knows of an array.
  const char* const name = given && *given ? given : nullptr;
  if (choice->Get(vtkDataObject::FIELD_ASSOCIATION()) != vtkDataObject::FIELD_ASSOCIATION_POINTS)
  {
    throw InputError("amplitudes of cells, expected a point array: apply Cell Data To Point Data");
  }
  vtkPointData* const data = cube->GetPointData();
  vtkDataArray* const own = data->GetScalars() ? data->GetScalars() : data->GetArray(PointArray::Amplitude);
  vtkDataArray* const array = name ? data->GetArray(name) : own;
  if (!array && own && own->GetName())
  {
    // ParaView scripts fill in an array of the active source if none is named.
    vtkWarningMacro(<< "no point array " << name << " in the image: amplitudes are those of " << own->GetName());
    return own;
  }
  if (!array)
  {
    throw InputError(name ? "no point array " + std::string(name) + " of numbers, expected one with amplitudes"
                          : std::string("no active scalars and no array Amplitude at the points of the image, expected "
                                        "amplitudes"));
  }
  return array;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkSeismicReflectionExtraction::ListHorizons(const Monitor& monitor)
{
  vtkImageData* const image = this->GetCube();
  ReflectionInputs inputs;
  vtkDataArray* const amplitudes = this->FindAmplitudes(image);
  inputs.Image = ReadImage(image, amplitudes);
  auto kept = std::make_unique<Kept>();
  kept->Read(image, image->GetUpdateTime());
  kept->Read(amplitudes);
  if (vtkDataObject* const picks = this->GetInputDataObject(GuidesPort, 0))
  {
    AddLeaves(picks, inputs.Guides.emplace());
  }
  for (int n = 0; n < this->GetNumberOfInputConnections(LimitsPort); ++n)
  {
    vtkDataObject* const limit = this->GetInputDataObject(LimitsPort, n);
    AddLeaves(limit, inputs.Limits ? *inputs.Limits : inputs.Limits.emplace());
    kept->Read(limit, limit->GetUpdateTime());
  }
  inputs.Side = this->LimitSide == Below ? LimitSide::Below : LimitSide::Above;
  kept->Inputs.emplace_back(nullptr, this->LimitSide);
  if (this->Joined && this->Joined->Inputs == kept->Inputs)
  {
    kept->Reflections = this->Joined->Reflections;
  }
  this->Joined.reset();
  this->Found = std::make_unique<Surfaces>();
  static_cast<FoundReflections&>(*this->Found) =
    FindReflections(std::move(inputs), this->MakeOptions(), monitor, &kept->Reflections);
  this->Joined = std::move(kept);
  for (const std::string& warning : this->Found->Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  const Extraction& result = this->Found->Result;
  this->NumberOfSurfaces = vtkIdType(result.NumberOfSurfaces);
  this->DominantPeriod = result.Period;
  this->EstimatedPhase = result.Phase.Degrees;
  this->PhaseDeviation = result.Phase.Deviation;
  this->Description = this->Found->Description;
  return this->Found->Names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> vtkSeismicReflectionExtraction::CountHorizonPoints()
{
  std::vector<std::int64_t> sizes;
  for (const LatticeHorizon& surface : this->Found->Result.Surfaces)
  {
    sizes.push_back(static_cast<std::int64_t>(surface.Column.size()));
  }
  return sizes;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkSeismicReflectionExtraction::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  const std::unique_ptr<Surfaces> found = std::exchange(this->Found, nullptr);
  std::vector<vtkSmartPointer<vtkDataObject>> horizons;
  for (const int number : numbers)
  {
    horizons.push_back(ToVTK(TakeSurface(*found, std::size_t(number), this->ZFrom == RealZ)));
    monitor.Progress(static_cast<double>(horizons.size()) / static_cast<double>(numbers.size()));
  }
  return horizons;
}
