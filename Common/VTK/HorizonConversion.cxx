// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonConversion.h"

#include "ArrayRanges.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Survey/DerivedArrays.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <array>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<int, 15> VTKTypes = { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
  VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT,
  VTK_DOUBLE, VTK_STRING };

// ---- Memory ---------------------------------------------------------------------------------------------------------

/// Deletes nothing but its reference to the array.
struct KeepArray
{
  vtkSmartPointer<vtkAbstractArray> Array;
  std::shared_ptr<void> Copied; // for an array of another layout
  vtkSmartPointer<vtkPoints> Points; // of places; other points with the array would mark it as modified
  void operator()(void*) const {}
};

/// The owners of memory that VTK's arrays use, until they return it.
class LentMemory
{
public:
  static void Lend(void* values, const std::shared_ptr<void>& owner)
  {
    const std::lock_guard<std::mutex> lock(Mutex());
    Owners().emplace(values, owner);
  }

  static void Return(void* values)
  {
    std::shared_ptr<void> owner; // It is freed without the lock.
    const std::lock_guard<std::mutex> lock(Mutex());
    const auto found = Owners().find(values);
    owner = std::move(found->second);
    Owners().erase(found);
  }

private:
  // These are never destroyed, since arrays may outlive statics.
  static std::mutex& Mutex()
  {
    static auto* const mutex = new std::mutex;
    return *mutex;
  }
  static std::unordered_multimap<void*, std::shared_ptr<void>>& Owners()
  {
    static auto* const owners = new std::unordered_multimap<void*, std::shared_ptr<void>>;
    return *owners;
  }
};

void UseMemory(const DataArray& array, vtkDataArray* made)
{
  made->SetNumberOfComponents(array.Components());
  if (array.Size() > 0)
  {
    LentMemory::Lend(array.Data(), array.Owner());
    made->SetVoidArray(array.Data(), array.Size(), 0, vtkAbstractArray::VTK_DATA_ARRAY_USER_DEFINED);
    made->SetArrayFreeFunction(LentMemory::Return);
  }
}

// ---- Arrays ---------------------------------------------------------------------------------------------------------

DataArray TextsOf(vtkAbstractArray* array)
{
  std::vector<std::string> texts(std::size_t(array->GetNumberOfValues()));
  for (std::size_t n = 0; n < texts.size(); ++n)
  {
    texts[n] = array->GetVariantValue(vtkIdType(n)).ToString();
  }
  const auto kept = std::make_shared<std::vector<std::string>>(std::move(texts));
  return { ValueType::Text, array->GetNumberOfTuples(), array->GetNumberOfComponents(), kept.get(),
    std::shared_ptr<void>(kept.get(), KeepArray{ array, kept, nullptr }) };
}

DataArray NumbersOf(vtkDataArray* array)
{
  const int type = array->GetDataType() == VTK_BIT ? VTK_UNSIGNED_CHAR : array->GetDataType();
  vtkSmartPointer<vtkDataArray> plain = array;
  if (!array->HasStandardMemoryLayout() || type != array->GetDataType())
  {
    plain.TakeReference(vtkDataArray::CreateDataArray(type));
    plain->DeepCopy(array);
  }
  const auto kind = std::find(VTKTypes.begin(), VTKTypes.end(), type) - VTKTypes.begin();
  void* const values = plain->GetNumberOfValues() > 0 ? plain->GetVoidPointer(0) : nullptr;
  const std::shared_ptr<void> copied(values, KeepArray{ plain, nullptr, nullptr });
  return { ValueType(kind), plain->GetNumberOfTuples(), plain->GetNumberOfComponents(), values,
    std::shared_ptr<void>(values, KeepArray{ array, copied, nullptr }) };
}

/// Arrays of stages have the classes of VTK that scripts know.
vtkSmartPointer<vtkAbstractArray> MakeArray(ValueType type)
{
  switch (type)
  {
    case ValueType::UnsignedChar:
      return vtkSmartPointer<vtkUnsignedCharArray>::New();
    case ValueType::Int:
      return vtkSmartPointer<vtkIntArray>::New();
    case ValueType::Float:
      return vtkSmartPointer<vtkFloatArray>::New();
    case ValueType::Double:
      return vtkSmartPointer<vtkDoubleArray>::New();
    default:
      return vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(VTKTypes[std::size_t(type)]));
  }
}

// ---- Cells ----------------------------------------------------------------------------------------------------------

/// Numbers of 64 bits have several types in VTK.
DataArray NumbersOfCells(vtkDataArray* given, bool areNarrow)
{
  const DataArray array = NumbersOf(given);
  return { areNarrow ? ValueType::Int : ValueType::Id, array.Tuples(), 1, array.Data(), array.Owner() };
}

template <typename Array>
vtkSmartPointer<vtkCellArray> MakeCellArray(const Cells& cells)
{
  vtkNew<Array> offsets;
  vtkNew<Array> points;
  UseMemory(cells.Offsets, offsets);
  UseMemory(cells.Points, points);
  auto made = vtkSmartPointer<vtkCellArray>::New();
  made->SetData(offsets, points);
  return made;
}

vtkSmartPointer<vtkCellArray> ToCellArray(const Cells& cells)
{
  if (cells.Offsets.Tuples() == 0)
  {
    return nullptr;
  }
  return cells.Offsets.Type() == ValueType::Int ? MakeCellArray<vtkTypeInt32Array>(cells)
                                                : MakeCellArray<vtkTypeInt64Array>(cells);
}
}

// ---- From VTK -------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
DataArray FromVTK(vtkAbstractArray* array)
{
  vtkDataArray* const numbers = vtkDataArray::SafeDownCast(array);
  DataArray plain = numbers ? NumbersOf(numbers) : TextsOf(array);
  plain.Name = array->GetName() ? array->GetName() : "";
  for (int n = 0; array->HasAComponentName() && n < array->GetNumberOfComponents(); ++n)
  {
    const char* const name = array->GetComponentName(n);
    plain.ComponentNames.emplace_back(name ? name : "");
  }
  if (array->HasInformation() && array->GetInformation()->Has(vtkDataArray::UNITS_LABEL()))
  {
    plain.Unit = array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  }
  return plain;
}

//----------------------------------------------------------------------------------------------------------------------
ArrayTable FromVTK(vtkFieldData* data)
{
  auto* const attributes = vtkDataSetAttributes::SafeDownCast(data);
  ArrayTable table;
  for (int n = 0; n < data->GetNumberOfArrays(); ++n)
  {
    DataArray array = FromVTK(data->GetAbstractArray(n));
    array.Role = attributes ? attributes->IsArrayAnAttribute(n) : -1;
    table.Add(std::move(array));
  }
  return table;
}

//----------------------------------------------------------------------------------------------------------------------
Cells FromVTK(vtkCellArray* cells)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return {};
  }
  return { NumbersOfCells(cells->GetOffsetsArray(), !cells->IsStorage64Bit()),
    NumbersOfCells(cells->GetConnectivityArray(), !cells->IsStorage64Bit()) };
}

//----------------------------------------------------------------------------------------------------------------------
Horizon FromVTK(vtkPolyData* given)
{
  Horizon horizon;
  if (given->GetPoints())
  {
    horizon.Places = FromVTK(given->GetPoints()->GetData());
    std::get_deleter<KeepArray>(horizon.Places.Owner())->Points = given->GetPoints();
  }
  horizon.Vertices = FromVTK(given->GetVerts());
  horizon.Lines = FromVTK(given->GetLines());
  horizon.Polygons = FromVTK(given->GetPolys());
  horizon.Strips = given->GetNumberOfStrips();
  horizon.PointData = FromVTK(given->GetPointData());
  horizon.CellData = FromVTK(given->GetCellData());
  horizon.FieldData = FromVTK(given->GetFieldData());
  RemoveDerivedArrays(horizon);
  return horizon;
}

// ---- To VTK ---------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkAbstractArray> ToVTK(const DataArray& array)
{
  const auto* const kept = std::get_deleter<KeepArray>(array.Owner());
  const char* const keptName = kept ? kept->Array->GetName() : nullptr;
  if (kept && array.Name == (keptName ? keptName : "") && kept->Array->GetNumberOfTuples() == array.Tuples())
  {
    return kept->Array;
  }
  const vtkSmartPointer<vtkAbstractArray> made = MakeArray(array.Type());
  if (auto* const texts = vtkStringArray::SafeDownCast(made))
  {
    texts->SetNumberOfComponents(array.Components());
    texts->SetNumberOfTuples(array.Tuples());
    std::copy(array.Texts().begin(), array.Texts().end(), texts->GetPointer(0));
  }
  else
  {
    UseMemory(array, vtkDataArray::SafeDownCast(made));
  }
  made->SetName(array.Name.empty() ? nullptr : array.Name.c_str());
  for (std::size_t n = 0; n < array.ComponentNames.size(); ++n)
  {
    made->SetComponentName(vtkIdType(n), array.ComponentNames[n].c_str());
  }
  if (!array.Unit.empty())
  {
    made->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), array.Unit.c_str());
  }
  return made;
}

//----------------------------------------------------------------------------------------------------------------------
void ToVTK(const ArrayTable& data, vtkFieldData* output)
{
  auto* const attributes = vtkDataSetAttributes::SafeDownCast(output);
  for (const DataArray& array : data)
  {
    const vtkSmartPointer<vtkAbstractArray> made = ToVTK(array);
    const int index = output->AddArray(made);
    if (attributes && array.Role >= 0)
    {
      attributes->SetActiveAttribute(index, array.Role);
    }
    FindRanges(vtkDataArray::SafeDownCast(made));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ToVTK(const ArrayTable& columns, vtkTable* output)
{
  for (const DataArray& column : columns)
  {
    output->AddColumn(ToVTK(column));
  }
}

//----------------------------------------------------------------------------------------------------------------------
void ToVTK(const Horizon& horizon, vtkPolyData* output)
{
  output->Initialize();
  const auto* const kept = std::get_deleter<KeepArray>(horizon.Places.Owner());
  vtkSmartPointer<vtkPoints> points = kept ? kept->Points : nullptr;
  if (!points)
  {
    points = vtkSmartPointer<vtkPoints>::New();
    if (horizon.Places.Components() == 3)
    {
      points->SetData(vtkDataArray::SafeDownCast(ToVTK(horizon.Places)));
    }
  }
  output->SetPoints(points);
  output->SetVerts(ToCellArray(horizon.Vertices));
  output->SetLines(ToCellArray(horizon.Lines));
  output->SetPolys(ToCellArray(horizon.Polygons));
  ToVTK(horizon.PointData, output->GetPointData());
  ToVTK(horizon.CellData, output->GetCellData());
  ToVTK(horizon.FieldData, output->GetFieldData());
  ToVTK(MakeDerivedArrays(horizon), output->GetPointData());
  FindRanges(points->GetData());
}

//----------------------------------------------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ToVTK(const Horizon& horizon)
{
  auto made = vtkSmartPointer<vtkPolyData>::New();
  ToVTK(horizon, made);
  return made;
}
}
