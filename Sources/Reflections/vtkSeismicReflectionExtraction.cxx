// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSeismicReflectionExtraction.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Base/Parameters.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/HorizonDataSet.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/SurveyFields.h"
#include "Filters/Algorithms/Reflections/ReflectionExtraction.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "ImageCube.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

using namespace SeismicHorizons;

namespace
{
constexpr int GuidesPort = 1;
constexpr int LimitsPort = 2;
}

struct vtkSeismicReflectionExtraction::Surfaces
{
  ImageCube Cube;
  std::vector<GuidePicks> Guides;
  ExtractionLimits Limits;
  Extraction Result;
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
  this->Found = std::make_unique<Surfaces>();
  this->Found->Cube = MakeImageCube(image, this->FindAmplitudes(image));
  std::vector<Guide> guides;
  if (vtkDataObject* const picks = this->GetInputDataObject(GuidesPort, 0))
  {
    this->Found->Guides = ReadGuides(picks, this->Found->Cube);
    for (const GuidePicks& guide : this->Found->Guides)
    {
      guides.push_back(guide.Given);
    }
  }
  if (const int limits = this->GetNumberOfInputConnections(LimitsPort))
  {
    std::vector<vtkDataObject*> horizons;
    for (int n = 0; n < limits; ++n)
    {
      horizons.push_back(this->GetInputDataObject(LimitsPort, n));
    }
    const auto side = this->LimitSide == Below ? LimitSide::Below : LimitSide::Above;
    this->Found->Limits = ReadLimits(horizons, this->Found->Cube, side);
  }
  this->Found->Result =
    ExtractReflections(this->Found->Cube.Traces, this->MakeOptions(), monitor, guides, this->Found->Limits.Traces);
  this->Describe();
  std::vector<std::string> names;
  for (std::size_t n = 0; n < this->Found->Result.Surfaces.size(); ++n)
  {
    names.push_back(n < guides.size() ? guides[n].Name : HorizonName(static_cast<int>(n - guides.size()) + 1));
  }
  return names;
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
void vtkSeismicReflectionExtraction::Describe()
{
  const Extraction& result = this->Found->Result;
  this->NumberOfSurfaces = static_cast<vtkIdType>(result.NumberOfSurfaces);
  this->DominantPeriod = result.Period;
  this->EstimatedPhase = result.Phase.Degrees;
  this->PhaseDeviation = result.Phase.Deviation;
  std::ostringstream text;
  text.precision(4);
  text << result.Samples << " samples, " << result.Picks << " picks of an amplitude of " << result.Threshold
       << " or more\n"
       << "dominant period " << result.Period << " samples, largest step " << result.LargestStep << '\n';
  text << "phase of the wavelet " << result.Phase.Degrees << " or " << result.Phase.Degrees + 180.0
       << " degrees, parts of the traces within " << result.Phase.Deviation << '\n';
  if (result.MedianCorrelation != 0.0)
  {
    text << "median correlation of links " << result.MedianCorrelation << '\n';
  }
  this->DescribeLimits(text);
  this->DescribeGuides(text);
  std::string description = text.str();
  if (this->Found->Guides.empty() || this->KeepOthers)
  {
    description += std::to_string(result.NumberOfSurfaces) + " surfaces of " + std::to_string(result.SmallestSize) +
      " picks or more, " + std::to_string(result.Surfaces.size() - this->Found->Guides.size()) + " taken\n";
  }
  description.pop_back(); // This drops the last newline.
  this->Description = std::move(description);
}

namespace
{
/// Picks are numbered from 1.
std::string GuidePicksText(const std::vector<std::size_t>& numbers, const GuidePicks& guide)
{
  constexpr std::size_t most = 5;
  std::ostringstream text;
  text << numbers.size() << " of " << guide.Places.size() << " picks, number";
  for (std::size_t n = 0; n < numbers.size() && n < most; ++n)
  {
    text << (n > 0 ? ", " : " ") << numbers[n] + 1;
  }
  const std::array<double, 3>& first = guide.Places[numbers.front()];
  text << (numbers.size() > most ? ", ..." : "") << ", the first at "
       << ToText(Eigen::Map<const Eigen::Vector3d>(first.data()));
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
void vtkSeismicReflectionExtraction::DescribeLimits(std::ostream& text)
{
  const ExtractionLimits& limits = this->Found->Limits;
  if (limits.Traces.AreNone())
  {
    return;
  }
  const auto traces = static_cast<std::int64_t>(limits.Traces.First.size());
  text << "limits on " << limits.Limited << " of " << traces << " traces\n";
  if (2 * limits.Limited < traces)
  {
    vtkWarningMacro(<< "limits on " << limits.Limited << " of " << traces
                    << " traces, expected them on most: nothing is found on the others; Horizon Hole Filling fills "
                       "horizons with holes");
  }
}

//----------------------------------------------------------------------------------------------------------------------
void vtkSeismicReflectionExtraction::DescribeGuides(std::ostream& text)
{
  const Extraction& result = this->Found->Result;
  for (std::size_t n = 0; n < this->Found->Guides.size(); ++n)
  {
    const GuidePicks& guide = this->Found->Guides[n];
    const GuideUse& use = result.Guides[n];
    const std::string name = "guide \"" + guide.Given.Name + "\": ";
    std::array<std::int64_t, 3> counts = { 0, 0, 0 };
    for (const double origin : result.Surfaces[n].Attributes.front().second)
    {
      ++counts[static_cast<std::size_t>(origin)];
    }
    text << guide.Given.Name << ": " << result.Surfaces[n].Column.size() << " points of "
         << (use.IsNegative ? "negative" : "positive") << " reflections, " << counts[0] << " picks, " << counts[1]
         << " on parts, " << counts[2] << " grown; unused picks: " << use.Unused.size() << " near no reflection, "
         << use.Strays.size() << " contradicted, " << guide.Outside << " outside of the cube\n";
    if (!use.Strays.empty())
    {
      vtkWarningMacro(<< name << GuidePicksText(use.Strays, guide)
                      << ", are on another event than those around them, expected one event: they were not followed");
    }
    if (2 * use.Unused.size() > guide.Places.size())
    {
      vtkWarningMacro(<< name << GuidePicksText(use.Unused, guide)
                      << ", are near no reflection of their sign, expected most to be: see GuideTolerance");
    }
    if (3 * use.OtherSign > static_cast<std::int64_t>(guide.Places.size()))
    {
      vtkWarningMacro(<< name << use.OtherSign << " of " << guide.Places.size()
                      << " picks are nearer to a reflection of " << (use.IsNegative ? "positive" : "negative")
                      << " amplitude than to one of the sign of the others, expected one sign");
    }
    constexpr std::int64_t many = 20; // One in 20 points may be shared, as guides meet along their rims.
    if (many * use.Shared > static_cast<std::int64_t>(result.Surfaces[n].Column.size()) + use.Shared)
    {
      vtkWarningMacro(<< name << use.Shared << " of its points were assigned to guide \""
                      << this->Found->Guides[use.SharedWith].Given.Name
                      << "\" or others, on the same event and nearer, expected different events");
    }
  }
}

namespace
{
/// Converts cube samples to lattice indices and world z.
void Place(LatticeHorizon& voxels, const ImageCube& cube)
{
  const int sign = static_cast<int>(cube.Frame.Direction);
  for (std::size_t n = 0; n < voxels.Column.size(); ++n)
  {
    voxels.Column[n].X += cube.FirstIndex[0];
    voxels.Column[n].Y += cube.FirstIndex[1];
    voxels.K[n] += cube.FirstIndex[2];
    voxels.RealZ[n] = sign * cube.Frame.Elevation(voxels.RealZ[n] + cube.FirstIndex[2]);
  }
}

void CopyFields(vtkFieldData* from, vtkFieldData* to)
{
  AddSurveyFields(ReadSurveyFields(from), to);
  if (vtkDataArray* const lines = from->GetArray(FieldArray::LineNumbers))
  {
    to->AddArray(lines);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataObject>> vtkSeismicReflectionExtraction::MakeHorizons(
  const std::vector<int>& numbers, const Monitor& monitor)
{
  const std::unique_ptr<Surfaces> found = std::exchange(this->Found, nullptr);
  ImageCube& cube = found->Cube;
  cube.Frame.UseRealZ = this->ZFrom == RealZ;
  std::vector<vtkSmartPointer<vtkDataObject>> horizons;
  for (const int number : numbers)
  {
    // Each horizon's voxels are freed once it is made.
    LatticeHorizon voxels = std::move(found->Result.Surfaces[static_cast<std::size_t>(number)]);
    Place(voxels, cube);
    vtkSmartPointer<vtkPolyData> horizon = MakeHorizonPoints(std::move(voxels), cube.Frame);
    CopyFields(this->GetCube()->GetFieldData(), horizon->GetFieldData());
    horizons.push_back(horizon);
    monitor.Progress(static_cast<double>(horizons.size()) / static_cast<double>(numbers.size()));
  }
  return horizons;
}
