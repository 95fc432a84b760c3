// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonThickness.h"

#include "Common/DataModel.h"
#include "Common/Errors.h"
#include "Common/KeptPoints.h"
#include "Common/Survey/ImageFrame.h"
#include "Common/VTK/ColumnImage.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonDataSet.h"
#include "Common/VTK/HorizonName.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/SurveyFields.h"
#include "Marshalling/HorizonData.h"
#include "Marshalling/HorizonPoints.h"
#include "Marshalling/HorizonTree.h"
#include "Marshalling/LatticePoints.h"
#include "Marshalling/PlacedPoints.h"
#include "Thickness/Thickness.h"

#include "vtkCompositeDataIterator.h"
#include "vtkDataObjectTree.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int OtherPort = 1; // of the input
constexpr int MapPort = 1; // of the output
constexpr std::int64_t Few = 20; // one column of so many may be a crossing without a warning

/// Of what has points, the one that is not the horizon itself, on the lattice of that; with the survey of both.
PlacedPoints ReadOther(vtkDataObject* others, vtkPolyData* horizon, const Lattice& lattice, SurveyDescription& survey)
{
  std::vector<HorizonLeaf> leaves = ListHorizons(others, {});
  leaves.erase(std::remove_if(leaves.begin(), leaves.end(),
                 [&](const HorizonLeaf& leaf)
                 { return leaf.Input->GetNumberOfPoints() == 0 || leaf.Input->GetPoints() == horizon->GetPoints(); }),
    leaves.end());
  if (leaves.size() != 1)
  {
    throw InputError(std::to_string(leaves.size()) +
      " other horizons with points, expected one as the input Other, for instance by Extract Block");
  }
  vtkPolyData* const other = leaves.front().Input;
  CheckArraySizes(other);
  survey = JoinSurveys(ReadSurveyFields(horizon->GetFieldData()), other, { "the other horizon", "the first one" });
  return PlaceOn(lattice, WithoutHiddenPoints(other), { "the other horizon", "the first one" });
}

LatticeScale ScaleOf(const Lattice& lattice)
{
  const Eigen::Vector3d origin = lattice.ToWorld(Eigen::Vector3d::Zero());
  LatticeScale scale;
  scale.Plane.col(0) = (lattice.ToWorld(Eigen::Vector3d::UnitX()) - origin).head<2>();
  scale.Plane.col(1) = (lattice.ToWorld(Eigen::Vector3d::UnitY()) - origin).head<2>();
  scale.Height = (lattice.ToWorld(Eigen::Vector3d::UnitZ()) - origin).z();
  return scale;
}

/// The map of a horizon with thickness. Throws InputError where steps are not perpendicular.
void MakeMap(vtkPolyData* horizon, vtkImageData* map)
{
  map->GetFieldData()->PassData(horizon->GetFieldData());
  if (horizon->GetNumberOfPoints() == 0)
  {
    return;
  }
  LatticeMatrix toWorld;
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(toWorld.data()) = ReadLatticeMap(horizon);
  PlaceImage(map, MakeMapFrame(toWorld));
  const ColumnPixels pixels(ColumnsOf(horizon), map);
  for (const char* const name : { PointArray::Isochore, PointArray::Isopach })
  {
    if (auto* const values = vtkDoubleArray::SafeDownCast(horizon->GetPointData()->GetArray(name)))
    {
      pixels.Add<vtkDoubleArray>(name, values->GetPointer(0), std::numeric_limits<double>::quiet_NaN());
    }
  }
  map->GetPointData()->SetActiveScalars(PointArray::Isochore);
}

/// Whether lengths along z and across it can be told together.
bool HasLengths(const SurveyDescription& survey)
{
  return survey.VerticalDomain != "time" &&
    (survey.VerticalUnit.empty() || survey.HorizontalUnit.empty() || survey.VerticalUnit == survey.HorizontalUnit);
}
}

vtkStandardNewMacro(vtkHorizonThickness);

//------------------------------------------------------------------------------
vtkHorizonThickness::vtkHorizonThickness()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkImageData* vtkHorizonThickness::GetMap()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(MapPort));
}

//------------------------------------------------------------------------------
int vtkHorizonThickness::RequestDataObject(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  MakeOutputLike<vtkImageData>(vtkDataObject::GetData(inputVector[0], 0), outputVector->GetInformationObject(MapPort));
  return this->Superclass::RequestDataObject(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkHorizonThickness::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  const LatticePoints points = ReadColumns(WithoutHiddenPoints(horizon), outputs);
  vtkDataObject* const given = this->GetInputDataObject(OtherPort, 0);
  SurveyDescription survey;
  const PlacedPoints other = ReadOther(given ? given : this->GetInputDataObject(0, 0), horizon, points.Lattice, survey);
  monitor.Progress(0.4);
  const Thickness found = MeasureThickness(
    { points.Column, points.Height }, { other.Columns, other.Height }, ScaleOf(points.Lattice), monitor.Step(0.4, 0.9));
  KeptPoints kept(found.Isochore.size());
  for (std::size_t point = 0; point < found.Isochore.size(); ++point)
  {
    kept.AppendRun(PointId(point), std::isnan(found.Isochore[point]) ? 0 : 1);
  }
  vtkPolyData* const output = outputs.front();
  CopyPoints(points.Horizon, kept, output);
  vtkPointData* const data = output->GetPointData();
  data->RemoveArray(PointArray::PatchId);
  data->RemoveArray(PointArray::Boundary);
  AddArray<vtkDoubleArray>(data, PointArray::Isochore, kept.Select(found.Isochore));
  vtkFieldData* const figures = output->GetFieldData();
  if (HasLengths(survey))
  {
    AddArray<vtkDoubleArray>(data, PointArray::Isopach, kept.Select(found.Isopach));
    AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreVolume, found.Volume);
  }
  data->SetActiveScalars(PointArray::Isochore);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreLeast, found.Least);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreMean, found.Mean);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreLargest, found.Largest);
  AddValue<vtkIdTypeArray>(figures, FieldArray::IsochoreCrossings, vtkIdType(found.Crossings));
  if (Few * found.Crossings > found.Columns)
  {
    const std::string name = NameBySurfaceId(horizon);
    vtkWarningMacro(<< name << (name.empty() ? "" : ": ") << "the horizons cross in " << found.Crossings << " of "
                    << found.Columns << " columns, expected few: their thickness is negative there");
  }
}

//------------------------------------------------------------------------------
void vtkHorizonThickness::ProcessOutputs(const std::vector<vtkDataObject*>& outputs)
{
  const auto make = [this](vtkDataObject* points, vtkImageData* map)
  { RunPart(this, true, "the map", { map }, [&]() { MakeMap(vtkPolyData::SafeDownCast(points), map); }); };
  auto* const tree = vtkDataObjectTree::SafeDownCast(outputs.front());
  if (!tree)
  {
    make(outputs.front(), vtkImageData::SafeDownCast(outputs[MapPort]));
    return;
  }
  auto* const maps = vtkDataObjectTree::SafeDownCast(outputs[MapPort]);
  maps->CopyStructure(tree);
  auto place = vtkSmartPointer<vtkCompositeDataIterator>::Take(tree->NewIterator());
  for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem())
  {
    vtkNew<vtkImageData> map;
    make(place->GetCurrentDataObject(), map);
    maps->SetDataSet(place, map);
  }
}
