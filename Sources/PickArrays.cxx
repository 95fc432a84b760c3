// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PickArrays.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/Types.h"
#include "Common/Survey/VerticalSense.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
std::vector<std::int64_t> ListRows(const PickArrays& picks)
{
  RequireTuples(picks.Arrays, picks.Rows, picks.Points ? "points" : "rows");
  const DataArray* const marks = picks.Points ? picks.Arrays.Find(PointArray::Ghosts) : nullptr;
  const unsigned char* const ghosts = marks ? marks->As<unsigned char>() : nullptr;
  std::vector<std::int64_t> kept;
  for (std::int64_t row = 0; row < picks.Rows; ++row)
  {
    if (!ghosts || !(ghosts[row] & (GhostMark::Copy | GhostMark::HiddenPoint)))
    {
      kept.push_back(row);
    }
  }
  return kept;
}

/// Other numbers are heights or attributes.
bool CanName(const DataArray& array)
{
  constexpr std::int64_t enough = 100;
  for (std::int64_t n = 0; !array.IsText() && n < std::min(enough, array.Tuples()); ++n)
  {
    if (array.At(n) != std::round(array.At(n)))
    {
      return false;
    }
  }
  return array.IsText() || array.Components() == 1;
}

class TableMaker
{
public:
  TableMaker(const PickArrays& source, const ColumnChoice& choice, const NullValues& nulls)
    : Source(source)
    , Kept(ListRows(source))
    , Choice(choice)
    , Nulls(nulls)
  {
  }

  PickTable Make()
  {
    if (this->Kept.empty())
    {
      throw InputError("no points, expected at least one");
    }
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
    if (z != this->Arrays.end() && IsElevation(z->second->Name))
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
      const DataArray* const array = this->Source.Arrays.Find(name);
      const bool isUsable = array && (!array->IsText() || role == FieldRole::HorizonName);
      if (!isUsable)
      {
        throw InputError(
          "no array of numbers " + name + " for " + RoleWord(role) + ", expected one of " + this->ListArrays());
      }
      this->Arrays[role] = array;
    }
    std::vector<std::string> zNames;
    for (const DataArray& array : this->Source.Arrays)
    {
      const FieldRole role = RoleOfName(array.Name);
      const bool isPlace = role == FieldRole::X || role == FieldRole::Y || role == FieldRole::Z;
      const bool isNumber = !array.IsText() && array.Components() == 1;
      if (role != FieldRole::Attribute && role != FieldRole::Ignored &&
        (role == FieldRole::HorizonName ? CanName(array) : isNumber) && !(isPlace && this->Source.Points))
      {
        this->Arrays.emplace(role, &array);
        if (role == FieldRole::Z)
        {
          zNames.push_back(array.Name);
        }
      }
    }
    const bool isChosen = std::any_of(
      this->Choice.begin(), this->Choice.end(), [](const auto& chosen) { return chosen.first == FieldRole::Z; });
    if (zNames.size() > 1 && !isChosen)
    {
      this->Arrays[FieldRole::Z] = this->Source.Arrays.Find(zNames[ChooseZ(zNames, "ZArray")]);
    }
  }

  /// Empty without an array or a coordinate.
  std::vector<double> Values(FieldRole role, int coordinate) const
  {
    const auto found = this->Arrays.find(role);
    if (found != this->Arrays.end())
    {
      return this->ValuesOf(*found->second, 0);
    }
    return coordinate >= 0 && this->Source.Points ? this->ValuesOf(*this->Source.Points, coordinate)
                                                  : std::vector<double>();
  }

  std::vector<double> ValuesOf(const DataArray& array, int component) const
  {
    std::vector<double> values(this->Kept.size());
    std::transform(this->Kept.begin(), this->Kept.end(), values.begin(),
      [&array, component](std::int64_t row) { return array.At(row, component); });
    return values;
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
    for (const std::int64_t row : this->Kept)
    {
      const std::string name = TextOf(*found->second, row);
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
    for (const DataArray& array : this->Source.Arrays)
    {
      if (array.IsText() || array.Name.empty() || this->HasRole(array) || array.Name == PointArray::Ghosts)
      {
        continue;
      }
      const int components = array.Components();
      for (int component = 0; component < components; ++component)
      {
        const std::string suffix = components == 1 ? "" : "_" + std::to_string(component);
        this->Table.Attributes.push_back({ array.Name + suffix, this->ValuesOf(array, component) });
        this->MarkNulls(this->Table.Attributes.back().Values);
      }
    }
  }

  bool HasRole(const DataArray& array) const
  {
    return std::any_of(
      this->Arrays.begin(), this->Arrays.end(), [&array](const auto& used) { return used.second == &array; });
  }

  std::string ListArrays() const
  {
    std::string names;
    for (const DataArray& array : this->Source.Arrays)
    {
      names += (names.empty() ? "" : ", ") + (array.Name.empty() ? "(no name)" : array.Name);
    }
    return names.empty() ? "(none)" : names;
  }

  const PickArrays& Source;
  const std::vector<std::int64_t> Kept; // rows
  const ColumnChoice& Choice;
  const NullValues& Nulls;
  std::map<FieldRole, const DataArray*> Arrays;
  PickTable Table;
};
}

//----------------------------------------------------------------------------------------------------------------------
PickTable MakePickTable(const PickArrays& picks, const ColumnChoice& choice, const NullValues& nulls)
{
  return TableMaker(picks, choice, nulls).Make();
}
}
