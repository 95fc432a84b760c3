// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonThickness.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/KeptPoints.h"
#include "Common/Survey/ImageFrame.h"
#include "Common/VTK/ColumnImage.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonDataSet.h"
#include "Common/VTK/LedgerFields.h"
#include "Common/VTK/PipelineRequest.h"
#include "Common/VTK/Ranks.h"
#include "Common/VTK/SurveyFields.h"
#include "Common/VTK/VertexCells.h"
#include "Filters/Algorithms/Thickness/Thickness.h"
#include "Filters/Marshalling/HorizonData.h"
#include "Filters/Marshalling/HorizonPoints.h"
#include "Filters/Marshalling/HorizonTree.h"
#include "Filters/Marshalling/LatticePoints.h"
#include "Filters/Marshalling/PlacedPoints.h"
#include "Filters/Marshalling/RankedHorizons.h"

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
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr int OtherPort = 1; // input port
constexpr int MapPort = 1; // output port
constexpr std::int64_t Few = 20; // Crossings in one of 20 columns cause no warning.

const HorizonNames OfOther = { "the other horizon", "the first one" };
const HorizonNames OfFirst = { "the first horizon", "the other one" };

/// Skips empty horizons and the horizon itself.
vtkPolyData* FindOther(const std::vector<vtkSmartPointer<vtkPolyData>>& others, vtkPolyData* horizon)
{
  std::vector<vtkPolyData*> found;
  for (vtkPolyData* const other : others)
  {
    if (other->GetNumberOfPoints() > 0 && other->GetPoints() != horizon->GetPoints())
    {
      found.push_back(other);
    }
  }
  if (found.size() != 1)
  {
    throw InputError(std::to_string(found.size()) +
      " other horizons with points, expected one as the input Other, for instance by Extract Block");
  }
  CheckArraySizes(found.front());
  return found.front();
}

/// Of points the lattice with the smaller bins is used, otherwise the lattice of the first horizon.
vtkPolyData* WithLattice(vtkPolyData* horizon, vtkPolyData* other)
{
  constexpr double smaller = 1.0 - 1e-6; // less than 1 by more than rounding
  const bool hasLattice = other->GetFieldData()->HasArray(FieldArray::LatticeToWorld);
  const bool isOther = hasLattice && !IsMesh(other) &&
    (IsMesh(horizon) || ReadLattice(other).ColumnArea() < smaller * ReadLattice(horizon).ColumnArea());
  return isOther ? other : horizon;
}

PlacedPoints PlaceInLattice(
  vtkPolyData* horizon, const Lattice& lattice, const HorizonNames& names, const Monitor& monitor)
{
  return IsMesh(horizon) ? SampleOn(lattice, horizon, names, monitor)
                         : PlaceOn(lattice, WithoutHiddenPoints(horizon), names);
}

/// The lattice may be of the other horizon.
void WriteSampled(const PlacedPoints& sampled, const KeptPoints& kept, vtkPolyData* withLattice, vtkPolyData* output)
{
  const Lattice lattice = ReadLattice(withLattice);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (std::size_t n = 0; n < kept.size(); ++n)
  {
    const auto point = std::size_t(kept[n]);
    const PlanePoint& column = sampled.Columns[point];
    const Eigen::Vector3d world = lattice.ToWorld({ double(column.X), double(column.Y), sampled.Height[point] });
    places->InsertNextPoint(world.data());
  }
  for (const char* const name : { FieldArray::LatticeDimensions, FieldArray::LatticeToWorld })
  {
    output->GetFieldData()->AddArray(withLattice->GetFieldData()->GetArray(name));
  }
  output->SetPoints(places);
  output->SetVerts(MakeVertices(output->GetNumberOfPoints()));
  output->GetPointData()->PassData(ReadColumns(output, {}, KeptHeights::None).Horizon->GetPointData());
}

/// `each` is the number of columns of the output that one column of the thickness stands for.
Ledger LedgerOf(const Thickness& found, std::int64_t each)
{
  Ledger ledger;
  ledger[LedgerEntry::Known] = each * found.Columns;
  ledger[LedgerEntry::LeftOut] = each * found.LeftOut;
  return ledger;
}

/// `bin` is the area of a column of the output.
void WriteThicknessFigures(const Thickness& found, double bin, vtkFieldData* figures)
{
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreLeast, found.Least);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreMean, found.Mean);
  AddValue<vtkDoubleArray>(figures, FieldArray::IsochoreLargest, found.Largest);
  AddValue<vtkIdTypeArray>(figures, FieldArray::IsochoreCrossings, vtkIdType(found.Crossings));
  WriteLedger(LedgerOf(found, std::int64_t(std::lround(found.Area / bin))), figures);
}

/// Empty without a warning.
std::string ReportWarnings(const Thickness& found)
{
  std::ostringstream text;
  if (Few * found.Crossings > found.Columns)
  {
    text << "the horizons cross in " << found.Crossings << " of " << found.Columns
         << " columns, expected few: their thickness is negative there";
  }
  if (!FindWarnings(LedgerOf(found, 1)).empty())
  {
    text << (text.str().empty() ? "" : "; ") << "one horizon alone is in " << found.LeftOut << " of "
         << found.Columns + found.LeftOut << " columns, an area of " << double(found.LeftOut) * found.Area
         << ", expected both: these columns are left out";
  }
  return text.str();
}

/// Throws InputError if steps are not perpendicular, or the map is too large.
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

/// z must have the unit of x and y.
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
// Without the input Other, the two horizons of the first input, which may be on different ranks, are a pair.
void vtkHorizonThickness::ShareHorizons(
  const std::vector<HorizonLeaf>& own, const std::vector<RankedHorizon>& all, const Ranks& ranks)
{
  this->Others.clear();
  vtkDataObject* const given = this->GetInputDataObject(OtherPort, 0);
  if (given || ranks.Size() == 1)
  {
    for (const HorizonLeaf& leaf : given ? ListHorizons(given, {}) : own)
    {
      this->Others.push_back(leaf.Input);
    }
    return;
  }
  std::vector<RankedHorizon> shared;
  std::copy_if(all.begin(), all.end(), std::back_inserter(shared),
    [](const RankedHorizon& horizon) { return horizon.Points > 0; });
  if (shared.size() > 2)
  {
    ranks.Refuse(std::to_string(shared.size()) + " horizons with points, expected two, or one as the input Other");
  }
  this->Others = ShareOnRanks(shared, own, ranks);
}

//------------------------------------------------------------------------------
void vtkHorizonThickness::ProcessHorizon(vtkPolyData* horizon, const Outputs& outputs, const Monitor& monitor)
{
  vtkPolyData* const output = outputs.front();
  vtkPolyData* const other = FindOther(this->Others, horizon);
  vtkPolyData* const withLattice = WithLattice(horizon, other);
  const SurveyDescription survey = JoinSurveys(ReadSurveyFields(horizon->GetFieldData()), other, OfOther);
  const Lattice lattice = ReadLattice(withLattice);
  monitor.Progress(0.0);
  const vtkSmartPointer<vtkPolyData> points =
    IsMesh(horizon) ? horizon : ReadColumns(WithoutHiddenPoints(horizon), outputs, KeptHeights::None).Horizon.Get();
  monitor.Progress(0.1);
  const PlacedPoints first = PlaceInLattice(points, lattice, OfFirst, monitor.Step(0.1, 0.3));
  monitor.Progress(0.3);
  const PlacedPoints second = PlaceInLattice(other, lattice, OfOther, monitor.Step(0.3, 0.5));
  const Thickness found = MeasureThickness({ first.Columns, first.Height.data() },
    { second.Columns, second.Height.data() }, ScaleOf(lattice), monitor.Step(0.5, 0.9));
  const auto kept =
    KeptPoints::If(found.Isochore.size(), [&found](std::size_t point) { return !std::isnan(found.Isochore[point]); });
  if (IsMesh(horizon))
  {
    WriteSampled(first, kept, withLattice, output);
  }
  else
  {
    CopyPoints(points, kept, output);
  }
  monitor.Progress(0.95);
  vtkPointData* const data = output->GetPointData();
  data->RemoveArray(PointArray::PatchId);
  data->RemoveArray(PointArray::Boundary);
  AddArray<vtkDoubleArray>(data, PointArray::Isochore, kept.Select(found.Isochore));
  if (HasLengths(survey))
  {
    AddArray<vtkDoubleArray>(data, PointArray::Isopach, kept.Select(found.Isopach));
    AddValue<vtkDoubleArray>(output->GetFieldData(), FieldArray::IsochoreVolume, found.Volume);
  }
  data->SetActiveScalars(PointArray::Isochore);
  WriteThicknessFigures(found, ReadLattice(output).ColumnArea(), output->GetFieldData());
  for (const std::string& warning : { ReportWarnings(found), WarnOfDirections(horizon, other, OfOther) })
  {
    if (!warning.empty())
    {
      this->Warn(warning);
    }
  }
}

//------------------------------------------------------------------------------
void vtkHorizonThickness::ProcessOutputs(const std::vector<vtkDataObject*>& outputs)
{
  this->Others.clear();
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
