// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Conversion between plain data and dictionaries of numpy arrays, which share the memory.

#ifndef SeismicHorizonsData_h
#define SeismicHorizonsData_h

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/NamedHorizon.h"
#include "Common/Horizon/VolumeGrid.h"

#include <nanobind/nanobind.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace nb = nanobind;

namespace SeismicHorizons
{
nb::object GiveArray(const DataArray& array);
nb::dict GiveTable(const ArrayTable& table);
/// Keys: places, has_vertices (one for each point), lines and polygons (offsets and points), point_data, cell_data,
/// field_data.
nb::dict GiveData(const Horizon& horizon);
nb::list GiveList(const std::vector<Horizon>& horizons);
/// Pairs of a name and data, and back.
nb::list GiveNamed(const std::vector<NamedHorizon>& horizons);
std::vector<NamedHorizon> TakeNamed(const nb::list& given);
/// Keys: places, cells, types, point_data, cell_data, field_data.
nb::dict GiveVolumes(const VolumeGrid& grid);

/// Arrays are contiguous, of numbers; texts are lists. Keys of GiveData may be missing.
DataArray TakeArray(const nb::handle& given);
ArrayTable TakeTable(const nb::dict& given, const char* name);
Horizon TakeData(const nb::dict& given);
VolumeGrid TakeVolumes(const nb::dict& given);

// ---- Options --------------------------------------------------------------------------------------------------------

template <typename T>
void Take(const nb::dict& given, const char* name, T& value)
{
  if (given.contains(name) && !nb::try_cast(given[name], value))
  {
    const auto text = nb::cast<std::string>(given[name].attr("__str__")());
    throw InputError(std::string(name) + " '" + text + "', expected another kind of value");
  }
}

template <typename T>
void Take(const nb::dict& given, const char* name, std::optional<T>& value)
{
  if (given.contains(name))
  {
    T own;
    Take(given, name, own);
    value = own;
  }
}

/// `words` are those of the values from 0 on.
template <typename Choice>
void TakeChoice(const nb::dict& given, const char* name, const std::vector<std::string>& words, Choice& choice)
{
  if (!given.contains(name))
  {
    return;
  }
  std::string word;
  Take(given, name, word);
  std::string expected;
  for (std::size_t n = 0; n < words.size(); ++n)
  {
    if (words[n] == word)
    {
      choice = static_cast<Choice>(n);
      return;
    }
    expected += (n == 0 ? "" : n + 1 == words.size() ? " or " : ", ") + words[n];
  }
  throw InputError(std::string(name) + " '" + word + "', expected " + expected);
}

struct SurfaceStageOptions;

SurfaceStageOptions TakeSurfaceOptions(const nb::dict& chosen);

// ---- Calls ----------------------------------------------------------------------------------------------------------

/// Runs work(monitor) without the lock. Raises what a signal or the progress callback raises.
template <typename Work>
auto Run(const nb::object& progress, Work&& work)
{
  const Monitor monitor(
    [&progress](double part)
    {
      const nb::gil_scoped_acquire lock;
      if (PyErr_CheckSignals() != 0)
      {
        return false;
      }
      if (!progress.is_none())
      {
        try
        {
          progress(part);
        }
        catch (nb::python_error& error)
        {
          error.restore();
          return false;
        }
      }
      return true;
    });
  try
  {
    const nb::gil_scoped_release unlocked;
    return work(monitor);
  }
  catch (const Aborted&)
  {
    if (!PyErr_Occurred()) // The callback ran in another thread.
    {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
    throw nb::python_error();
  }
}

// ---- Parts of the module --------------------------------------------------------------------------------------------

void BindReading(nb::module_& module);
void BindStages(nb::module_& module);
void BindLayers(nb::module_& module);
void BindCutoffs(nb::module_& module);
void BindSealed(nb::module_& module);
void BindCubes(nb::module_& module);
void BindWriting(nb::module_& module);
}

#endif
