// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ArrayRanges.h"

#include "Common/Base/FixedChunks.h"
#include "Common/Base/Monitor.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationInformationVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace SeismicHorizons
{
namespace
{
constexpr std::int64_t Large = 100000; // tuples
constexpr int MostComponents = 3;

struct ValueRange
{
  double Least = std::numeric_limits<double>::infinity();
  double Largest = -std::numeric_limits<double>::infinity();
};

/// The ranges of the components, and last that of the squared length.
struct ArrayRanges
{
  std::array<ValueRange, MostComponents + 1> Of;

  void Add(const ArrayRanges& other)
  {
    for (std::size_t n = 0; n < this->Of.size(); ++n)
    {
      this->Of[n].Least = std::min(this->Of[n].Least, other.Of[n].Least);
      this->Of[n].Largest = std::max(this->Of[n].Largest, other.Of[n].Largest);
    }
  }
};

/// Tuples take turns in lanes, which are vectors of the processor. NaN is in no range, as in VTK.
template <int Components, typename Value>
ArrayRanges FindInChunk(const Value* values, std::int64_t size)
{
  constexpr std::int64_t lanes = 8;
  constexpr int last = Components;
  double least[Components + 1][lanes];
  double largest[Components + 1][lanes];
  std::fill_n(&least[0][0], (Components + 1) * lanes, std::numeric_limits<double>::infinity());
  std::fill_n(&largest[0][0], (Components + 1) * lanes, -std::numeric_limits<double>::infinity());
  const auto add = [&](std::int64_t tuple, std::int64_t lane)
  {
    double square = 0.0;
    for (int n = 0; n < Components; ++n)
    {
      const auto value = double(values[tuple * Components + n]);
      least[n][lane] = value < least[n][lane] ? value : least[n][lane];
      largest[n][lane] = value > largest[n][lane] ? value : largest[n][lane];
      square += value * value;
    }
    least[last][lane] = square < least[last][lane] ? square : least[last][lane];
    largest[last][lane] = square > largest[last][lane] ? square : largest[last][lane];
  };
  std::int64_t first = 0;
  for (; first + lanes <= size; first += lanes)
  {
    for (std::int64_t lane = 0; lane < lanes; ++lane)
    {
      add(first + lane, lane);
    }
  }
  for (; first < size; ++first)
  {
    add(first, 0);
  }
  ArrayRanges ranges;
  for (int n = 0; n <= Components; ++n)
  {
    ranges.Of[std::size_t(n == last ? MostComponents : n)] = { *std::min_element(least[n], least[n] + lanes),
      *std::max_element(largest[n], largest[n] + lanes) };
  }
  return ranges;
}

template <int Components, typename Value>
ArrayRanges FindIn(const Value* values, std::int64_t size)
{
  return AddUpChunks<ArrayRanges>(size, ChunkSize, Monitor(),
    [&](ArrayRanges& ranges, std::int64_t first, std::int64_t end)
    { ranges = FindInChunk<Components>(values + first * Components, end - first); });
}

template <typename Value>
ArrayRanges FindIn(const Value* values, int components, std::int64_t size)
{
  return components == 1 ? FindIn<1>(values, size)
    : components == 2    ? FindIn<2>(values, size)
                         : FindIn<3>(values, size);
}

/// Other types are those of users.
ArrayRanges FindIn(vtkDataArray* array)
{
  const int components = array->GetNumberOfComponents();
  const std::int64_t size = array->GetNumberOfTuples();
  if (auto* const floats = vtkFloatArray::FastDownCast(array))
  {
    return FindIn(floats->GetPointer(0), components, size);
  }
  if (auto* const doubles = vtkDoubleArray::FastDownCast(array))
  {
    return FindIn(doubles->GetPointer(0), components, size);
  }
  if (auto* const integers = vtkIntArray::FastDownCast(array))
  {
    return FindIn(integers->GetPointer(0), components, size);
  }
  if (auto* const bytes = vtkUnsignedCharArray::FastDownCast(array))
  {
    return FindIn(bytes->GetPointer(0), components, size);
  }
  return {};
}
}

//----------------------------------------------------------------------------------------------------------------------
void FindRanges(vtkDataArray* array)
{
  const int components = array ? array->GetNumberOfComponents() : 0;
  if (components == 0 || array->GetNumberOfTuples() < Large || components > MostComponents ||
    (array->HasInformation() && array->GetInformation()->Has(vtkAbstractArray::PER_FINITE_COMPONENT())))
  {
    return;
  }
  const ArrayRanges ranges = FindIn(array);
  const auto isFinite = [](const ValueRange& range)
  { return std::isfinite(range.Least) && std::isfinite(range.Largest); };
  if (!std::all_of(ranges.Of.begin(), ranges.Of.begin() + components, isFinite) || !isFinite(ranges.Of.back()))
  {
    return;
  }
  vtkInformation* const known = array->GetInformation();
  for (vtkInformationInformationVectorKey* const key :
    { vtkAbstractArray::PER_COMPONENT(), vtkAbstractArray::PER_FINITE_COMPONENT() })
  {
    vtkNew<vtkInformationVector> each;
    each->SetNumberOfInformationObjects(components);
    for (int component = 0; component < components; ++component)
    {
      const ValueRange& range = ranges.Of[std::size_t(component)];
      const double ends[2] = { range.Least, range.Largest };
      each->GetInformationObject(component)->Set(vtkDataArray::COMPONENT_RANGE(), ends, 2);
    }
    known->Set(key, each);
  }
  const ValueRange& square = ranges.Of.back();
  const double lengths[2] = { std::sqrt(square.Least), std::sqrt(square.Largest) };
  known->Set(vtkDataArray::L2_NORM_RANGE(), lengths, 2);
  known->Set(vtkDataArray::L2_NORM_FINITE_RANGE(), lengths, 2);
}
}
