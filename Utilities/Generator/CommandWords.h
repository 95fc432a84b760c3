// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the programs of the generators have in common: the words of their command lines, and files as a whole or not at
// all.

#ifndef SeismicHorizonsCommandWords_h
#define SeismicHorizonsCommandWords_h

#include "Common/Base/Errors.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace SeismicHorizons
{
template <typename Number>
Number ParseNumber(const std::string& option, const std::string& text)
{
  Number number = {};
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc() || end != last)
  {
    throw InputError(option + " \"" + text + "\", expected a number in range");
  }
  return number;
}

/// Hands out the words of the command line.
class CommandWords
{
public:
  CommandWords(int argc, char* argv[])
    : All(argv + 1, argv + argc)
  {
  }

  bool AtEnd() const { return this->Next == this->All.size(); }
  const std::string& Take() { return this->All[this->Next++]; }

  template <typename Number>
  void Take(const std::string& option, Number& number)
  {
    number = ParseNumber<Number>(option, this->TakeText(option, "a number"));
  }

  /// The word behind an option.
  const std::string& TakeText(const std::string& option, const std::string& expected)
  {
    if (this->AtEnd())
    {
      throw InputError(option + " without a value, expected " + expected);
    }
    return this->Take();
  }

private:
  std::vector<std::string> All;
  std::size_t Next = 0;
};

/// Calls write(stream) for a new file. No part of a file stays behind when that throws; a device or a pipe does.
template <typename Write>
void WriteWholeFile(const std::string& fileName, Write&& write)
{
  std::ofstream stream(fileName, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error("cannot be opened for writing");
  }
  try
  {
    write(stream);
  }
  catch (...)
  {
    stream.close();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(fileName, ignored))
    {
      std::filesystem::remove(fileName, ignored);
    }
    throw;
  }
}
}

#endif
