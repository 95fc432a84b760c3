// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Survey/LatticeFrame.h"
#include "SEGYCube.h"

#include <sstream>

namespace SeismicHorizons
{
namespace
{
std::string DescribeFile(const SEGYHeader& header)
{
  std::ostringstream text;
  text << "SEG-Y" << (header.Revision > 0 ? " revision " + std::to_string(header.Revision) : "") << ", "
       << FormatName(header.Format) << ", " << (header.Order == ByteOrder::BigEndian ? "big" : "little")
       << "-endian, text in " << (header.IsEbcdic ? "EBCDIC" : "ASCII");
  if (header.ExtendedTexts > 0)
  {
    text << ", " << header.ExtendedTexts << " extended text headers";
  }
  text << '\n'
       << header.Traces << " traces of " << header.Samples << " samples"
       << (header.HasOwnSamples ? "" : " (by the first trace)");
  return text.str();
}

std::string FieldText(int byte)
{
  return byte == NoField ? "no byte" : "byte " + std::to_string(byte);
}

std::string DescribeLines(const SEGYCube& cube)
{
  const SurveyLattice& lattice = cube.Lattice;
  std::ostringstream text;
  const auto describe = [&text](const char* what, double first, double step, int count, int byte)
  {
    text << count << ' ' << what << (count == 1 ? " " : "s ") << first;
    if (count > 1)
    {
      text << " to " << first + step * (count - 1) << " in steps of " << step;
    }
    text << " (" << FieldText(byte) << ")\n";
  };
  text.precision(10);
  describe("inline", lattice.Lines->FirstInline, lattice.Lines->InlineStep, lattice.Columns[1], cube.LineFields.First);
  describe("crossline", lattice.Lines->FirstCrossline, lattice.Lines->CrosslineStep, lattice.Columns[0],
    cube.LineFields.Second);
  text << "sorted by " << (cube.IsCrosslineSorted ? "crosslines" : "inlines") << "; " << cube.MissingTraces
       << " traces missing, " << cube.DeadTraces << " dead";
  if (cube.DuplicateTraces > 0)
  {
    text << ", " << cube.DuplicateTraces << " at places of others";
  }
  if (cube.Fillers > 0)
  {
    text << ", " << cube.Fillers << " dead ones without line numbers";
  }
  return text.str();
}

std::string DescribePlaces(const SEGYCube& cube)
{
  const SurveyLattice& lattice = cube.Lattice;
  std::ostringstream text;
  if (cube.PlaceFields.First == NoField)
  {
    text << "x and y are line numbers";
  }
  else
  {
    text << "x and y at bytes " << cube.PlaceFields.First << " and " << cube.PlaceFields.Second << ": from "
         << ToText(lattice.Origin) << " in steps of " << ToText(lattice.ColumnStep) << " along crosslines' numbers and "
         << ToText(lattice.RowStep) << " along inlines'";
    text.precision(3);
    text << "; traces at most " << cube.LargestDistance << " of a step off";
    text << (cube.StrayPlaces > 0 ? ", but for " + std::to_string(cube.StrayPlaces) : "");
  }
  return text.str();
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string Describe(const SEGYCube& cube)
{
  std::ostringstream text;
  text << DescribeFile(cube.Header) << '\n' << DescribeLines(cube) << '\n' << DescribePlaces(cube) << '\n';
  text << cube.Sampling.Indices << " vertical indices from " << cube.Sampling.First << " in steps of "
       << cube.Sampling.Step << (cube.Delays.empty() ? "" : "; traces begin at different ones");
  return text.str();
}

//----------------------------------------------------------------------------------------------------------------------
std::string WarningText(const SEGYCube& cube)
{
  std::string text;
  for (const std::string& warning : cube.Warnings)
  {
    text += (text.empty() ? "" : "; ") + warning;
  }
  return text;
}
}
