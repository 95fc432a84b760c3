// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonFromPoints.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "Common/Survey/FieldRole.h"
#include "Common/Survey/NullValues.h"
#include "Common/Survey/PickTable.h"
#include "Common/Survey/VerticalSense.h"
#include "Common/VTK/DataArrays.h"
#include "Common/VTK/HorizonName.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
/// Array names by role; roles not listed are found by the usual names.
using ColumnChoice = std::map<FieldRole, std::string>;

struct Rows
{
  explicit Rows(vtkDataObject* data)
  {
    if (auto* const table = vtkTable::SafeDownCast(data))
    {
      this->Arrays = table->GetRowData();
      this->List(table->GetNumberOfRows(), nullptr);
    }
    else if (auto* const points = vtkPointSet::SafeDownCast(data))
    {
      this->Arrays = points->GetPointData();
      this->Points = points->GetPoints() ? points->GetPoints()->GetData() : nullptr;
      this->List(points->GetNumberOfPoints(), points->GetPointGhostArray());
    }
  }

  std::vector<double> Values(vtkDataArray* array, int component) const
  {
    std::vector<double> values(this->Kept.size());
    std::transform(this->Kept.begin(), this->Kept.end(), values.begin(),
      [array, component](vtkIdType row) { return array->GetComponent(row, component); });
    return values;
  }

  void List(vtkIdType rows, vtkUnsignedCharArray* ghosts)
  {
    RequireTuples(this->Arrays, rows, this->Points ? "points" : "rows");
    constexpr int left = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
    for (vtkIdType row = 0; row < rows; ++row)
    {
      if (!ghosts || !(ghosts->GetValue(row) & left))
      {
        this->Kept.push_back(row);
      }
    }
  }

  vtkDataSetAttributes* Arrays = nullptr; // null for other data than tables and points
  vtkDataArray* Points = nullptr; // coordinates, or null
  std::vector<vtkIdType> Kept;
};

/// Other numbers are heights or attributes.
bool CanName(vtkAbstractArray* array)
{
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  constexpr vtkIdType enough = 100;
  for (vtkIdType n = 0; numbers && n < std::min(enough, numbers->GetNumberOfTuples()); ++n)
  {
    if (numbers->GetComponent(n, 0) != std::round(numbers->GetComponent(n, 0)))
    {
      return false;
    }
  }
  return !numbers || numbers->GetNumberOfComponents() == 1;
}

class TableMaker
{
public:
  TableMaker(const Rows& rows, const ColumnChoice& choice, const NullValues& nulls)
    : Source(rows)
    , Choice(choice)
    , Nulls(nulls)
  {
  }

  PickTable Make()
  {
    this->FindArrays();
    this->AddNames();
    this->Table.Z = this->Values(FieldRole::Z, 2);
    this->MarkNulls(this->Table.Z);
    this->AddPair(FieldRole::X, FieldRole::Y, this->Table.X, this->Table.Y);
    this->AddPair(FieldRole::Inline, FieldRole::Crossline, this->Table.Inline, this->Table.Crossline);
    if (this->Table.Z.empty() || !(this->Table.HasPlaces() || this->Table.HasLines()))
    {
      throw InputError(
        "arrays " + this->ListArrays() + ", expected Z, and X and Y or Inline and Crossline, of numbers");
    }
    this->AddAttributes();
    const auto z = this->Arrays.find(FieldRole::Z);
    if (z != this->Arrays.end() && IsElevation(z->second->GetName()))
    {
      this->Table.Survey.IsUpright = true;
    }
    return std::move(this->Table);
  }

private:
  /// Chosen arrays come before names. Coordinates of point sets serve as x, y and z.
  void FindArrays()
  {
    for (const auto& [role, name] : this->Choice)
    {
      vtkAbstractArray* const array = this->Source.Arrays->GetAbstractArray(name.c_str());
      const bool isUsable = array && (vtkDataArray::SafeDownCast(array) || role == FieldRole::HorizonName);
      if (!isUsable)
      {
        throw InputError(
          "no array of numbers " + name + " for " + RoleWord(role) + ", expected one of " + this->ListArrays());
      }
      this->Arrays[role] = array;
    }
    std::vector<std::string> zNames;
    for (int n = 0; n < this->Source.Arrays->GetNumberOfArrays(); ++n)
    {
      vtkAbstractArray* const array = this->Source.Arrays->GetAbstractArray(n);
      const FieldRole role = RoleOfName(array->GetName() ? array->GetName() : "");
      const bool isPlace = role == FieldRole::X || role == FieldRole::Y || role == FieldRole::Z;
      const bool isNumber = vtkDataArray::SafeDownCast(array) && array->GetNumberOfComponents() == 1;
      if (role != FieldRole::Attribute && role != FieldRole::Ignored &&
        (role == FieldRole::HorizonName ? CanName(array) : isNumber) && !(isPlace && this->Source.Points))
      {
        this->Arrays.emplace(role, array);
        if (role == FieldRole::Z)
        {
          zNames.emplace_back(array->GetName());
        }
      }
    }
    const bool isChosen = std::any_of(
      this->Choice.begin(), this->Choice.end(), [](const auto& chosen) { return chosen.first == FieldRole::Z; });
    if (zNames.size() > 1 && !isChosen)
    {
      this->Arrays[FieldRole::Z] = this->Source.Arrays->GetAbstractArray(zNames[ChooseZ(zNames, "ZArray")].c_str());
    }
  }

  /// Empty without an array or a coordinate.
  std::vector<double> Values(FieldRole role, int coordinate) const
  {
    const auto found = this->Arrays.find(role);
    if (found != this->Arrays.end())
    {
      return this->Source.Values(vtkDataArray::SafeDownCast(found->second), 0);
    }
    return coordinate >= 0 && this->Source.Points ? this->Source.Values(this->Source.Points, coordinate)
                                                  : std::vector<double>();
  }

  void MarkNulls(std::vector<double>& values) const
  {
    for (double& value : values)
    {
      value = std::isfinite(value) && !this->Nulls.IsNullNumber(value) ? value : NoValue;
    }
  }

  void AddPair(FieldRole firstRole, FieldRole secondRole, std::vector<double>& first, std::vector<double>& second)
  {
    const bool mayBeCoordinates = firstRole == FieldRole::X;
    first = this->Values(firstRole, mayBeCoordinates ? 0 : -1);
    second = this->Values(secondRole, mayBeCoordinates ? 1 : -1);
    if (first.size() != second.size())
    {
      first.clear();
      second.clear();
    }
    for (std::size_t n = 0; n < first.size(); ++n)
    {
      if (!std::isfinite(first[n]) || !std::isfinite(second[n]))
      {
        throw InputError("point " + std::to_string(n) + " at " + RoleWord(firstRole) + " " + std::to_string(first[n]) +
          ", " + RoleWord(secondRole) + " " + std::to_string(second[n]) + ", expected finite numbers");
      }
    }
  }

  void AddNames()
  {
    const auto found = this->Arrays.find(FieldRole::HorizonName);
    if (found == this->Arrays.end())
    {
      this->Table.Names = { "" };
      return;
    }
    std::unordered_map<std::string, int> numbers;
    for (const vtkIdType row : this->Source.Kept)
    {
      const std::string name = found->second->GetVariantValue(row).ToString();
      const auto [place, isNew] = numbers.emplace(name, static_cast<int>(numbers.size()));
      if (isNew)
      {
        this->Table.Names.push_back(name);
      }
      this->Table.Horizon.push_back(place->second);
    }
  }

  void AddAttributes()
  {
    for (int n = 0; n < this->Source.Arrays->GetNumberOfArrays(); ++n)
    {
      auto* const array = vtkDataArray::SafeDownCast(this->Source.Arrays->GetAbstractArray(n));
      if (!array || !array->GetName() || this->HasRole(array) ||
        array->GetName() == std::string(vtkDataSetAttributes::GhostArrayName()))
      {
        continue;
      }
      const int components = array->GetNumberOfComponents();
      for (int component = 0; component < components; ++component)
      {
        const std::string suffix = components == 1 ? "" : "_" + std::to_string(component);
        this->Table.Attributes.push_back({ array->GetName() + suffix, this->Source.Values(array, component) });
        this->MarkNulls(this->Table.Attributes.back().Values);
      }
    }
  }

  bool HasRole(vtkAbstractArray* array) const
  {
    return std::any_of(
      this->Arrays.begin(), this->Arrays.end(), [array](const auto& used) { return used.second == array; });
  }

  std::string ListArrays() const
  {
    std::string names;
    for (int n = 0; n < this->Source.Arrays->GetNumberOfArrays(); ++n)
    {
      const char* const name = this->Source.Arrays->GetAbstractArray(n)->GetName();
      names += (names.empty() ? "" : ", ") + std::string(name ? name : "(no name)");
    }
    return names.empty() ? "(none)" : names;
  }

  const Rows& Source;
  const ColumnChoice& Choice;
  const NullValues& Nulls;
  std::map<FieldRole, vtkAbstractArray*> Arrays;
  PickTable Table;
};

/// Coordinates of points are used unless an array is chosen for x, y or z. Ghost points are skipped. Throws InputError
/// without a chosen array, z or places, and on infinite places.
PickTable MakePickTable(vtkDataObject* data, const ColumnChoice& choice, const NullValues& nulls)
{
  const Rows rows(data);
  if (!rows.Arrays)
  {
    throw InputError("no input, expected a table or points");
  }
  if (rows.Kept.empty())
  {
    throw InputError("no points, expected at least one");
  }
  return TableMaker(rows, choice, nulls).Make();
}
}
}

using namespace SeismicHorizons;
vtkStandardNewMacro(vtkHorizonFromPoints);

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonFromPoints::vtkHorizonFromPoints()
{
  this->SetNumberOfInputPorts(1);
}

//----------------------------------------------------------------------------------------------------------------------
vtkHorizonFromPoints::~vtkHorizonFromPoints()
{
  this->SetXArray(nullptr);
  this->SetYArray(nullptr);
  this->SetZArray(nullptr);
  this->SetInlineArray(nullptr);
  this->SetCrosslineArray(nullptr);
  this->SetNameArray(nullptr);
  this->SetNullValues(nullptr);
}

//----------------------------------------------------------------------------------------------------------------------
int vtkHorizonFromPoints::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> vtkHorizonFromPoints::ListNames(const Monitor& monitor)
{
  monitor.Progress(0.0);
  ColumnChoice choice;
  const std::pair<FieldRole, const char*> given[] = { { FieldRole::X, this->XArray }, { FieldRole::Y, this->YArray },
    { FieldRole::Z, this->ZArray }, { FieldRole::Inline, this->InlineArray },
    { FieldRole::Crossline, this->CrosslineArray }, { FieldRole::HorizonName, this->NameArray } };
  for (const auto& [role, name] : given)
  {
    if (name && *name)
    {
      choice[role] = name;
    }
  }
  const SeismicHorizons::NullValues nulls(this->NullValues ? this->NullValues : "");
  this->Picks = std::make_unique<PickTable>(MakePickTable(this->GetInputDataObject(0, 0), choice, nulls));
  this->PickTime.Modified();
  std::vector<std::string> names = this->Picks->Names;
  for (std::size_t number = 0; number < names.size(); ++number)
  {
    names[number] = names[number].empty() ? HorizonName(static_cast<std::int64_t>(number) + 1) : names[number];
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::int64_t> vtkHorizonFromPoints::CountPicks()
{
  return this->Picks->CountPicks();
}

//----------------------------------------------------------------------------------------------------------------------
vtkMTimeType vtkHorizonFromPoints::GetPickTime()
{
  return this->PickTime.GetMTime();
}

//----------------------------------------------------------------------------------------------------------------------
PickTable vtkHorizonFromPoints::ReadPicks(const Monitor&)
{
  assert(this->Picks);
  return std::move(*std::exchange(this->Picks, nullptr));
}
