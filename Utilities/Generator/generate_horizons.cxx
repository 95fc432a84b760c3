// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a file of synthetic horizons. See `generate_horizons --help`.

#include "AnticlineSurvey.h"
#include "CommandWords.h"
#include "HorizonGenerator.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

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
  --anticline       instead of all that: two horizons of a survey in time, on a faulted anticline with a channel,
                    of which the lower one is truncated by the upper one
  --help            this text
)";

struct Arguments
{
  HorizonGeneratorOptions Options;
  std::int64_t NumberOfPoints = 0; // 0: as Options.Size says
  std::string FileName;
  bool IsAnticline = false;
  bool Help = false;
};

void ParseOption(const std::string& option, CommandWords& words, Arguments& arguments)
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
  std::string option; // one that says what the horizons are like
  CommandWords words(argc, argv);
  while (!words.AtEnd())
  {
    const std::string word = words.Take();
    if (word == "--help" || word == "-h")
    {
      arguments.Help = true;
      return arguments;
    }
    if (word == "--anticline")
    {
      arguments.IsAnticline = true;
    }
    else if (word.size() > 1 && word[0] == '-')
    {
      ParseOption(word, words, arguments);
      hasPoints = hasPoints || word == "--points";
      option = word;
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
  if (arguments.IsAnticline && !option.empty())
  {
    throw InputError(option + " beside --anticline, expected no other option");
  }
  if (hasPoints)
  {
    arguments.Options.Size = HorizonGenerator::FindSize(arguments.Options, arguments.NumberOfPoints);
  }
  return arguments;
}

template <typename Write>
void WriteFile(const std::string& fileName, const SparseMatrixSize& size, Write write)
{
  WriteWholeFile(fileName,
    [&](std::ostream& stream)
    {
      const auto [nX, nY, nZ] = size;
      const std::map<int, std::int64_t> counts = write(stream);
      std::cout << fileName << ": " << nX << " x " << nY << " x " << nZ << " cells\n";
      for (const auto& [surfaceId, numberOfVoxels] : counts)
      {
        std::cout << "Horizon " << surfaceId << ": " << numberOfVoxels << " voxels\n";
      }
    });
}

void WriteFile(const Arguments& arguments)
{
  if (arguments.IsAnticline)
  {
    WriteFile(arguments.FileName, AnticlineSurveySize, WriteAnticlineSurvey);
    return;
  }
  const HorizonGenerator generator(arguments.Options);
  WriteFile(
    arguments.FileName, generator.Options().Size, [&](std::ostream& stream) { return generator.Write(stream); });
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
    WriteFile(arguments);
  }
  catch (const std::exception& error)
  {
    const std::string file = arguments.FileName.empty() ? "" : arguments.FileName + ": ";
    std::cerr << "generate_horizons: " << file << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
