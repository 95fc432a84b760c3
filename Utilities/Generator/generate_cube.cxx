// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a synthetic seismic cube. See `generate_cube --help`.

#include "CommandWords.h"
#include "CubeGenerator.h"
#include "SEGYPrinter.h"

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

using namespace SeismicHorizons;

namespace
{
constexpr const char* Usage = R"(usage: generate_cube [options] FILE

Writes a synthetic seismic cube with known horizons as SEG-Y (IEEE floats; inline and crossline at bytes 189 and 193, x
and y at 181 and 185; a turned survey). The same options give the same file everywhere.

  --hard            layers thick and thin that fade and face others across the fault, a channel, dead and missing
                    traces; the seed chooses frequency and throw. Options after it change that
  --wild            the same, larger, with two channels, an unconformity, and short faults beside the long one
  --size NX NY NZ   crosslines, inlines and samples (default 80 64 220)
  --interval MS     from sample to sample (default 4)
  --frequency HZ    of the Ricker wavelet (default 30)
  --spacing N       from reflector to reflector, in samples (default 32)
  --variation PART  part of it that is random, 0 to 0.9 (default 0)
  --folds N         height of folds, in samples (default 10)
  --throw N         of the fault, in samples; 0 for none (default 16)
  --dip N           how many columns the fault moves in a sample (default 0.15)
  --weakest PART    strength of the weakest reflector (default 0.4)
  --fading PART     to what part of their strength reflectors fade here and there (default 1)
  --channels N      each cuts into a reflector, one into the middle one (default 0)
  --short-faults N  whose throw ends inside the cube (default 0)
  --unconformity    older layers are tilted and cut off, and younger ones end against the surface
  --phase DEGREES   of the wavelet (default 0)
  --dead PART       traces of zeros (default 0)
  --missing PART    traces that are not there (default 0)
  --noise PART      root mean square of the noise, as a part of the signal's (default 0)
  --in-band         noise of the frequencies of the signal
  --coherent        noise of dipping plane waves
  --mixed           noise of all three kinds
  --lateral         half white, and half in band and alike in columns nearby
  --trouble NAME    polarity (it turns), wavelet (longer below), multiples, dead-strips, gas-cloud, salt, reef, footprint,
                    clipped (to 8 bits), statics, smiles (of migration), growth-fault or clinoforms; several may be given
  --seed N          another number gives another cube (default 1)
  --truth TEXT      another file, with the place of each reflector in each column as text
  --help            this text
)";

struct Arguments
{
  CubeGeneratorOptions Options;
  std::string FileName;
  std::string TruthName;
  bool Help = false;
};

const std::map<std::string, NoiseKind> Noises = { { "--in-band", NoiseKind::InBand },
  { "--coherent", NoiseKind::Coherent }, { "--mixed", NoiseKind::Mixed }, { "--lateral", NoiseKind::Lateral } };

/// Options with one number.
bool ParseNumberOption(const std::string& option, CommandWords& words, CubeGeneratorOptions& options)
{
  const std::map<std::string, double*> numbers = { { "--interval", &options.SampleInterval },
    { "--frequency", &options.Frequency }, { "--spacing", &options.Spacing },
    { "--variation", &options.SpacingVariation }, { "--folds", &options.FoldHeight },
    { "--throw", &options.FaultThrow }, { "--dip", &options.FaultDip }, { "--weakest", &options.SmallestStrength },
    { "--fading", &options.Fading }, { "--dead", &options.DeadFraction }, { "--missing", &options.MissingFraction },
    { "--noise", &options.NoiseFraction }, { "--phase", &options.Phase } };
  const auto found = numbers.find(option);
  if (found == numbers.end())
  {
    return false;
  }
  words.Take(option, *found->second);
  return true;
}

void ParseOption(const std::string& option, CommandWords& words, Arguments& arguments)
{
  CubeGeneratorOptions& options = arguments.Options;
  if (ParseNumberOption(option, words, options))
  {
    return;
  }
  if (option == "--size")
  {
    for (int& n : options.Size)
    {
      words.Take(option, n);
    }
  }
  else if (option == "--seed")
  {
    words.Take(option, options.Seed);
  }
  else if (option == "--channels")
  {
    words.Take(option, options.Channels);
  }
  else if (option == "--short-faults")
  {
    words.Take(option, options.ShortFaults);
  }
  else if (option == "--unconformity")
  {
    options.HasUnconformity = true;
  }
  else if (const auto noise = Noises.find(option); noise != Noises.end())
  {
    options.Noise = noise->second;
  }
  else if (option == "--trouble")
  {
    const std::string name = words.TakeText(option, "a name");
    const auto trouble = TroubleNames().find(name);
    if (trouble == TroubleNames().end())
    {
      throw InputError("trouble \"" + name + "\", expected one of those that --help lists");
    }
    options.Troubles.insert(trouble->second);
  }
  else if (option == "--truth")
  {
    arguments.TruthName = words.TakeText(option, "a file");
  }
  else
  {
    throw InputError("option \"" + option + "\", expected one of those that --help lists");
  }
}

/// The seed behind --seed, wherever it stands: --hard needs it first.
std::uint64_t FindSeed(CommandWords words, std::uint64_t usual)
{
  while (!words.AtEnd())
  {
    if (words.Take() == "--seed")
    {
      words.Take("--seed", usual);
    }
  }
  return usual;
}

Arguments ParseArguments(int argc, char* argv[])
{
  Arguments arguments;
  CommandWords words(argc, argv);
  while (!words.AtEnd() && !arguments.Help)
  {
    const std::string word = words.Take();
    if (word == "--help" || word == "-h")
    {
      arguments.Help = true;
    }
    else if (word == "--hard" || word == "--wild")
    {
      const std::uint64_t seed = FindSeed(CommandWords(argc, argv), arguments.Options.Seed);
      arguments.Options = word == "--hard" ? HardCube(seed) : WildCube(seed);
    }
    else if (word.size() > 1 && word[0] == '-')
    {
      ParseOption(word, words, arguments);
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
  if (arguments.FileName.empty() && !arguments.Help)
  {
    throw InputError("no file, expected the path to write to");
  }
  return arguments;
}

void WriteFiles(const Arguments& arguments)
{
  const CubeGenerator generator(arguments.Options);
  const CubeSurvey survey;
  WriteWholeFile(arguments.FileName,
    [&](std::ostream& stream) { WriteSEGY(arguments.Options, generator.MakeTraces(), survey, stream); });
  if (!arguments.TruthName.empty())
  {
    WriteWholeFile(arguments.TruthName, [&](std::ostream& stream) { WriteTruth(generator, survey, stream); });
  }
  const auto [nX, nY, nZ] = arguments.Options.Size;
  std::cout << arguments.FileName << ": " << nX << " x " << nY << " traces of " << nZ << " samples, "
            << generator.Truth().Size() << " reflectors\n";
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
    WriteFiles(arguments);
  }
  catch (const std::exception& error)
  {
    const std::string file = arguments.FileName.empty() ? "" : arguments.FileName + ": ";
    std::cerr << "generate_cube: " << file << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
