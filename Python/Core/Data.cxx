// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Data.h"

#include <nanobind/ndarray.h>

#include <array>
#include <cstdint>
#include <memory>

namespace SeismicHorizons
{
namespace
{
// ---- To numpy -------------------------------------------------------------------------------------------------------

template <typename T>
nb::object GiveNumbers(T* numbers, const DataArray& array)
{
  using Owner = std::shared_ptr<void>;
  const nb::capsule owner(new Owner(array.Owner()), [](void* kept) noexcept { delete static_cast<Owner*>(kept); });
  const auto tuples = std::size_t(array.Tuples());
  const auto components = std::size_t(array.Components());
  return components == 1 ? nb::cast(nb::ndarray<nb::numpy, T, nb::ndim<1>>(numbers, { tuples }, owner))
                         : nb::cast(nb::ndarray<nb::numpy, T, nb::ndim<2>>(numbers, { tuples, components }, owner));
}

nb::object GiveCells(const Cells& cells)
{
  return nb::make_tuple(GiveArray(cells.Offsets), GiveArray(cells.Points));
}

// ---- From numpy -----------------------------------------------------------------------------------------------------

using AnyArray = nb::ndarray<nb::ro, nb::c_contig, nb::device::cpu>;

ValueType TypeOfNumbers(const AnyArray& array)
{
  using Code = nb::dlpack::dtype_code;
  struct Known
  {
    Code Kind;
    int Bits;
    ValueType Type;
  };
  constexpr std::array<Known, 11> types = { { { Code::Bool, 8, ValueType::UnsignedChar },
    { Code::Int, 8, ValueType::SignedChar }, { Code::UInt, 8, ValueType::UnsignedChar },
    { Code::Int, 16, ValueType::Short }, { Code::UInt, 16, ValueType::UnsignedShort },
    { Code::Int, 32, ValueType::Int }, { Code::UInt, 32, ValueType::UnsignedInt }, { Code::Int, 64, ValueType::Id },
    { Code::UInt, 64, ValueType::UnsignedLongLong }, { Code::Float, 32, ValueType::Float },
    { Code::Float, 64, ValueType::Double } } };
  for (const Known& known : types)
  {
    if (std::uint8_t(known.Kind) == array.dtype().code && known.Bits == array.dtype().bits)
    {
      return known.Type;
    }
  }
  throw InputError("an array of a type that is neither a number of up to 64 bits nor text, expected one of these");
}

Cells TakeCells(const nb::dict& given, const char* name)
{
  if (!given.contains(name))
  {
    return {};
  }
  const auto cells = nb::cast<nb::tuple>(given[name]);
  return { TakeArray(cells[0]), TakeArray(cells[1]) };
}
}

// ---- To numpy -------------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
nb::object GiveArray(const DataArray& array)
{
  if (array.IsText())
  {
    return nb::cast(array.Texts());
  }
  nb::object given;
  array.WithNumbers(
    [&](auto* numbers)
    {
      using T = std::decay_t<decltype(*numbers)>;
      using Plain = std::conditional_t<std::is_same_v<T, char>, signed char, T>;
      given = GiveNumbers(reinterpret_cast<Plain*>(numbers), array);
    });
  return given;
}

//----------------------------------------------------------------------------------------------------------------------
nb::dict GiveTable(const ArrayTable& table)
{
  nb::dict given;
  for (const DataArray& array : table)
  {
    given[array.Name.c_str()] = GiveArray(array);
  }
  return given;
}

//----------------------------------------------------------------------------------------------------------------------
nb::dict GiveData(const Horizon& horizon)
{
  nb::dict given;
  given["places"] = GiveArray(horizon.Places);
  given["has_vertices"] = horizon.Vertices.Size() > 0;
  given["lines"] = GiveCells(horizon.Lines);
  given["polygons"] = GiveCells(horizon.Polygons);
  given["point_data"] = GiveTable(horizon.PointData);
  given["cell_data"] = GiveTable(horizon.CellData);
  given["field_data"] = GiveTable(horizon.FieldData);
  return given;
}

//----------------------------------------------------------------------------------------------------------------------
nb::list GiveList(const std::vector<Horizon>& horizons)
{
  nb::list given;
  for (const Horizon& horizon : horizons)
  {
    given.append(GiveData(horizon));
  }
  return given;
}

//----------------------------------------------------------------------------------------------------------------------
nb::list GiveNamed(const std::vector<NamedHorizon>& horizons)
{
  nb::list given;
  for (const NamedHorizon& horizon : horizons)
  {
    given.append(nb::make_tuple(horizon.Name, GiveData(horizon.Data)));
  }
  return given;
}

//----------------------------------------------------------------------------------------------------------------------
nb::dict GiveVolumes(const VolumeGrid& grid)
{
  nb::dict given;
  given["places"] = GiveArray(grid.Places);
  given["cells"] = GiveCells(grid.Cells);
  given["types"] = GiveArray(grid.Types);
  given["point_data"] = GiveTable(grid.PointData);
  given["cell_data"] = GiveTable(grid.CellData);
  given["field_data"] = GiveTable(grid.FieldData);
  return given;
}

// ---- From numpy -----------------------------------------------------------------------------------------------------

//----------------------------------------------------------------------------------------------------------------------
DataArray TakeArray(const nb::handle& given)
{
  if (nb::isinstance<nb::list>(given))
  {
    return { "", nb::cast<std::vector<std::string>>(given) };
  }
  auto* const kept = new AnyArray(nb::cast<AnyArray>(given));
  const std::shared_ptr<void> owner(const_cast<void*>(kept->data()),
    [kept](void*)
    {
      const nb::gil_scoped_acquire lock;
      delete kept;
    });
  const std::size_t axes = kept->ndim();
  if (axes < 1 || axes > 2)
  {
    throw InputError("an array of " + std::to_string(axes) + " axes, expected one or two");
  }
  return { TypeOfNumbers(*kept), std::int64_t(kept->shape(0)), axes == 1 ? 1 : int(kept->shape(1)), owner.get(),
    owner };
}

//----------------------------------------------------------------------------------------------------------------------
ArrayTable TakeTable(const nb::dict& given, const char* name)
{
  ArrayTable table;
  if (given.contains(name))
  {
    for (const auto& [key, values] : nb::cast<nb::dict>(given[name]))
    {
      DataArray array = TakeArray(values);
      array.Name = nb::cast<std::string>(key);
      table.Add(std::move(array));
    }
  }
  return table;
}

//----------------------------------------------------------------------------------------------------------------------
Horizon TakeData(const nb::dict& given)
{
  Horizon horizon;
  horizon.Places = TakeArray(given["places"]);
  horizon.Lines = TakeCells(given, "lines");
  horizon.Polygons = TakeCells(given, "polygons");
  horizon.PointData = TakeTable(given, "point_data");
  horizon.CellData = TakeTable(given, "cell_data");
  horizon.FieldData = TakeTable(given, "field_data");
  return horizon;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<NamedHorizon> TakeNamed(const nb::list& given)
{
  std::vector<NamedHorizon> horizons;
  for (const nb::handle& one : given)
  {
    const auto pair = nb::cast<nb::tuple>(one);
    horizons.push_back({ nb::cast<std::string>(pair[0]), TakeData(nb::cast<nb::dict>(pair[1])) });
    CheckArraySizes(horizons.back().Data);
  }
  return horizons;
}

//----------------------------------------------------------------------------------------------------------------------
VolumeGrid TakeVolumes(const nb::dict& given)
{
  VolumeGrid grid;
  grid.Places = TakeArray(given["places"]);
  grid.Cells = TakeCells(given, "cells");
  grid.Types = TakeArray(given["types"]);
  grid.PointData = TakeTable(given, "point_data");
  grid.CellData = TakeTable(given, "cell_data");
  grid.FieldData = TakeTable(given, "field_data");
  return grid;
}
}
