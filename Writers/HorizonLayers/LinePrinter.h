// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLinePrinter_h
#define SeismicHorizonsLinePrinter_h

#include "Common/Base/Monitor.h"
#include "Common/Text/TextPrinter.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace SeismicHorizons
{
class LinePrinter
{
public:
  explicit LinePrinter(std::ostream& stream)
    : Out(stream)
  {
  }

  template <typename Value>
  LinePrinter& Add(const Value& value)
  {
    if constexpr (std::is_same_v<Value, double>)
    {
      this->Out.Print(value);
    }
    else if constexpr (std::is_integral_v<Value>)
    {
      this->Out.Print(std::int64_t(value));
    }
    else
    {
      this->Out.Print(std::string_view(value));
    }
    return *this;
  }

  template <typename First, typename... Others>
  void Line([[maybe_unused]] std::string_view between, const First& first, const Others&... others)
  {
    this->Add(first);
    (this->Add(between).Add(others), ...);
    this->Add("\n");
  }

  void Flush() { this->Out.Flush(); }

private:
  TextPrinter Out;
};

template <typename Work>
void ForEach(std::size_t count, const Monitor& monitor, Work&& work)
{
  constexpr std::size_t betweenReports = 1 << 14;
  for (std::size_t n = 0; n < count; ++n)
  {
    if (n % betweenReports == 0)
    {
      monitor.Progress(double(n) / double(count));
    }
    work(n);
  }
}

inline std::string WithoutQuotes(std::string name)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c == '"' || std::iscntrl(static_cast<unsigned char>(c)); }, '_');
  return name;
}
}

#endif
