// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a file of synthetic horizons. See `generate_horizons --help`.

#include "HorizonGenerator.h"

#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

using namespace SeismicHorizons;

namespace
{
constexpr const char* Usage = R"(usage: generate_horizons [options] FILE

Writes synthetic seismic horizons as a sparse-matrix file (.vsm). The same options give the same file everywhere.

  --size NX NY NZ   cells of the lattice (default 240 200 120); NZ at least 5 times the number of horizons
  --points N        instead of NX and NY: the lattice, in their proportions, for about N voxels in the file,
                    all horizons together
  --horizons N      horizons in the cube (default 3)
  --holes N         holes in each horizon, the first of them large (default 8)
  --islands N       islands of each horizon, the first of them in its large hole (default 3)
  --dropouts PART   part of the voxels that are missing one by one, 0 to 0.1 (default 0.02)
  --squareness Q    outlines from a star (-1) over a circle (0, the default) to a square (1)
  --noise PART      part of the area in patches of noise, 0 (the default) to 1
  --noise-height H  by how many cells heights are off there, up and down (default 3)
  --noise-gaps PART part of the voxels that are missing there, 0 to below 1 (default 0.5)
  --seed N          another number gives other horizons (default 1)
  --help            this text
)";

struct Arguments
{
  HorizonGeneratorOptions Options;
  std::int64_t NumberOfPoints = 0; // 0: as Options.Size says
  std::string FileName;
  bool Help = false;
};

template <typename Number>
Number Parse(const std::string& option, const std::string& text)
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
class Words
{
public:
  Words(int argc, char* argv[])
    : All(argv + 1, argv + argc)
  {
  }

  bool AtEnd() const { return this->Next == this->All.size(); }
  const std::string& Take() { return this->All[this->Next++]; }

  template <typename Number>
  void Take(const std::string& option, Number& number)
  {
    if (this->AtEnd())
    {
      throw InputError(option + " without a value, expected a number");
    }
    number = Parse<Number>(option, this->Take());
  }

private:
  std::vector<std::string> All;
  std::size_t Next = 0;
};

void ParseOption(const std::string& option, Words& words, Arguments& arguments)
{
  HorizonGeneratorOptions& options = arguments.Options;
  if (option == "--size")
  {
    for (int& n : options.Size)
    {
      words.Take(option, n);
    }
  }
  else if (option == "--points")
  {
    words.Take(option, arguments.NumberOfPoints);
  }
  else if (option == "--horizons")
  {
    words.Take(option, options.NumberOfHorizons);
  }
  else if (option == "--holes")
  {
    words.Take(option, options.NumberOfHoles);
  }
  else if (option == "--islands")
  {
    words.Take(option, options.NumberOfIslands);
  }
  else if (option == "--squareness")
  {
    words.Take(option, options.Squareness);
  }
  else if (option == "--dropouts")
  {
    words.Take(option, options.DropoutFraction);
  }
  else if (option == "--noise")
  {
    words.Take(option, options.NoiseFraction);
  }
  else if (option == "--noise-height")
  {
    words.Take(option, options.NoiseHeight);
  }
  else if (option == "--noise-gaps")
  {
    words.Take(option, options.NoiseGaps);
  }
  else if (option == "--seed")
  {
    words.Take(option, options.Seed);
  }
  else
  {
    throw InputError("option \"" + option + "\", expected one of those that --help lists");
  }
}

Arguments ParseArguments(int argc, char* argv[])
{
  Arguments arguments;
  bool hasPoints = false;
  Words words(argc, argv);
  while (!words.AtEnd())
  {
    const std::string word = words.Take();
    if (word == "--help" || word == "-h")
    {
      arguments.Help = true;
      return arguments;
    }
    if (word.size() > 1 && word[0] == '-')
    {
      ParseOption(word, words, arguments);
      hasPoints = hasPoints || word == "--points";
    }
    else if (arguments.FileName.empty())
    {
      arguments.FileName = word;
    }
    else
    {
      throw InputError("a second file \"" + word + "\", expected one");
    }
  }
  if (arguments.FileName.empty())
  {
    throw InputError("no file, expected the path to write to");
  }
  if (hasPoints)
  {
    arguments.Options.Size = HorizonGenerator::FindSize(arguments.Options, arguments.NumberOfPoints);
  }
  return arguments;
}

void WriteFile(const HorizonGenerator& generator, const std::string& fileName)
{
  std::ofstream stream(fileName, std::ios::binary);
  if (!stream)
  {
    throw std::runtime_error("can not be opened for writing");
  }
  try
  {
    const auto [nX, nY, nZ] = generator.Options().Size;
    const std::map<int, std::int64_t> counts = generator.Write(stream);
    std::cout << fileName << ": " << nX << " x " << nY << " x " << nZ << " cells\n";
    for (const auto& [surfaceId, numberOfVoxels] : counts)
    {
      std::cout << "Horizon " << surfaceId << ": " << numberOfVoxels << " voxels\n";
    }
  }
  catch (...)
  {
    // No part of a file stays behind; a device or a pipe does.
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

int main(int argc, char* argv[])
{
  Arguments arguments;
  try
  {
    arguments = ParseArguments(argc, argv);
    if (arguments.Help)
    {
      std::cout << Usage;
      return EXIT_SUCCESS;
    }
    WriteFile(HorizonGenerator(arguments.Options), arguments.FileName);
  }
  catch (const std::exception& error)
  {
    const std::string file = arguments.FileName.empty() ? "" : arguments.FileName + ": ";
    std::cerr << "generate_horizons: " << file << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
